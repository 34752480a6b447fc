#include "cmd/profile_options.h"

const char *wf_profile_word(size_t i) { return wf_profiles[i].name; }

struct wf_profile_words wf_profile_asked(const struct wf_args *g)
{
    return (struct wf_profile_words){ .name = wf_args_text(g, "--profile"),
                                      .file = wf_args_text(g, "--profile-file"),
                                      .reference_height = wf_args_number(g, "--reference-height"),
                                      .exponent = wf_args_number(g, "--exponent"),
                                      .roughness = wf_args_number(g, "--roughness"),
                                      .displacement = wf_args_number(g, "--displacement"),
                                      .canopy_height = wf_args_number(g, "--canopy-height"),
                                      .attenuation = wf_args_number(g, "--attenuation") };
}
