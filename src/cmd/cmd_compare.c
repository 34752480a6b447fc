#include "cmd/study.h"

int wf_cmd_compare(int argc, char **argv)
{
    static const char about[] = "Every species is grown on the same model, so that a comparison shows "
                                "material and section alone (a model "
                                "may leave the base radius to the species).\n"
                                "\n"
                                "  windfirm compare species/moso_bamboo.yaml species/weeping_willow.yaml \\\n"
                                "      --model models/culm.yaml --wind 10,15,25 -o out/mine";
    return wf_study_run(argc, argv, about, 2, 32);
}
