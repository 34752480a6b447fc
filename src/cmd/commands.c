#include "cmd/cmd.h"

const struct wf_command wf_commands[] = {
    { "analyze", "SPECIES --model MODEL --wind SPEEDS [option...]",
      "What the wind does to one species on one tree model: loads, bending, stress, safety, critical wind "
      "speed.",
      wf_cmd_analyze },
    { "compare", "SPECIES SPECIES... --model MODEL --wind SPEEDS [option...]",
      "The same for several species on the same tree model, side by side.", wf_cmd_compare },
    { "import", "FILE... [-o FILE] [option...]",
      "Read measured trees from the files other programs write, repair them, write them in one form.",
      wf_cmd_import },
    { "report", "FOLDER [option...]",
      "Draw plots and pages again from the results.json and tables of an earlier run.", wf_cmd_report },
    { "schema", "species|model",
      "Every key of a species table or a tree model: dimension, range, default, meaning.", wf_cmd_schema },
    { "species", "list | show NAME", "The species tables that are shipped, and what is in one.",
      wf_cmd_species },
    { "tree", "info FILE... [option...]",
      "Size of measured trees, and what had to be repaired.", wf_cmd_tree },
    { "validate", "[PATH...] [option...]", "Run validation cases and compare with their sources.",
      wf_cmd_validate },
    { 0 },
};
