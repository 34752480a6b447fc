#include "cmd/cmd.h"

const struct wf_command wf_commands[] = {
    { "analyze", "SPECIES --model MODEL --wind SPEEDS [option...]",
      "What the wind does to one species on one tree model: loads, bending, stress, safety, critical wind "
      "speed.",
      wf_cmd_analyze },
    { "compare", "SPECIES SPECIES... --model MODEL --wind SPEEDS [option...]",
      "The same for several species on the same tree model, side by side.", wf_cmd_compare },
    { "report", "FOLDER [option...]",
      "Draw plots and pages again from the results.json and tables of an earlier run.", wf_cmd_report },
    { "schema", "species|model",
      "Every key of a species table or a tree model: dimension, range, default, meaning.", wf_cmd_schema },
    { "species", "list | show NAME", "The species tables that are shipped, and what is in one.",
      wf_cmd_species },
    { "validate", "[PATH...] [option...]", "Run validation cases and compare with their sources.",
      wf_cmd_validate },
    { 0 },
};
