#include "fit/experiment.h"

const struct wf_sensor_row wf_sensor_rows[WF_SENSOR_KINDS] = {
    [WF_SENSOR_DEFLECTION] = { "deflection", WF_DIM_LENGTH, "mm", 1e3, true },
    [WF_SENSOR_HORIZONTAL] = { "horizontal", WF_DIM_LENGTH, "mm", 1e3, true },
    [WF_SENSOR_VERTICAL] = { "vertical", WF_DIM_LENGTH, "mm", 1e3, true },
    [WF_SENSOR_TILT] = { "tilt", WF_DIM_ANGLE, "deg", 180 / 3.14159265358979323846, true },
    [WF_SENSOR_STRAIN] = { "strain", WF_DIM_NONE, "um/m", 1e6, true },
    [WF_SENSOR_EXTENSION] = { "extension", WF_DIM_LENGTH, "um", 1e6, true },
    [WF_SENSOR_REACH] = { "reach", WF_DIM_LENGTH, "mm", 1e3, true },
    [WF_SENSOR_RISE] = { "rise", WF_DIM_LENGTH, "mm", 1e3, true },
    [WF_SENSOR_MOMENT] = { "base_moment", WF_DIM_MOMENT, "kN m", 1e-3, false },
    [WF_SENSOR_FREQUENCY] = { "frequency", WF_DIM_FREQUENCY, "Hz", 1, false },
    [WF_SENSOR_DAMPING] = { "damping", WF_DIM_NONE, "%", 100, false },
};
