#include "cmd/study.h"

int wf_cmd_analyze(int argc, char **argv)
{
    static const char about[] =
        "SPECIES is a species table, a file or the name of a shipped one ('windfirm species list'). The wind "
        "is "
        "steady; the tree bends until its stiffness balances wind and weight, and the wind is taken on the "
        "bent "
        "shape. Deflection is counted from the unloaded shape, so it holds the sag under weight as well.\n"
        "\n"
        "  windfirm analyze species/moso_bamboo.yaml --model models/moso_culm.yaml --wind 5:40:1";
    return wf_study_run(argc, argv, about, 1, 1);
}
