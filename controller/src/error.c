#include <twiddle/error.h>

const char *twd_error_text(enum twd_error error)
{
    switch (error) {
    case TWD_OK:
        return "no error";
    case TWD_ERROR_TICK:
        return "the tick must be above 0 and at most 0.1 s";
    case TWD_ERROR_TOO_MANY_OSCILLATORS:
        return "a CPG must have at least one oscillator and at most TWD_MAX_OSCILLATORS";
    case TWD_ERROR_TOO_MANY_COUPLINGS:
        return "a CPG must have at most TWD_MAX_COUPLINGS couplings";
    case TWD_ERROR_COUPLING:
        return "a coupling must join two different oscillators of its CPG";
    case TWD_ERROR_TOO_MANY_JOINTS:
        return "a CPG must drive at least one joint and at most TWD_MAX_JOINTS, all CPGs of a controller as many as it "
               "has";
    case TWD_ERROR_JOINT_OSCILLATOR:
        return "each joint must be driven by an oscillator of the CPG";
    case TWD_ERROR_TOO_MANY_CPGS:
        return "a model must have at least one CPG and at most TWD_MAX_CPGS";
    case TWD_ERROR_CHAIN:
        return "a finger chain must have 1 to TWD_MAX_CHAIN_JOINTS joints, the moving ones first, each a joint of the "
               "controller";
    case TWD_ERROR_RANGE:
        return "a setting is not a number, or outside the range that its field allows";
    case TWD_ERROR_PARAMETER_COUNT:
        return "the number of parameters must be the model's";
    case TWD_ERROR_PARAMETER:
        return "each parameter must be a number from 0 to 1";
    case TWD_ERROR_LEARNER_SIZE:
        return "a learner must have at least one unit and one input and at most TWD_MAX_UNITS and TWD_MAX_INPUTS";
    case TWD_ERROR_NULL:
        return "a table or a setting that the set-up needs is a null pointer";
    }
    return "an unknown error";
}
