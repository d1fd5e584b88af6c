#include <twiddle/model.h>

#include <twiddle/gate.h>
#include <twiddle/phase.h>

static size_t topology_parameters(const struct twd_topology *topology, bool with_centre)
{
    const size_t frequency = topology->chooses_frequency ? 1 : 0;
    const size_t shapes = with_centre ? 2 : 1;
    return frequency + shapes * topology->oscillators + topology->couplings;
}

size_t twd_model_parameters(const struct twd_model *model, bool with_centre)
{
    size_t count = 0;
    for (uint8_t k = 0; k < model->cpgs; k++)
        count += topology_parameters(model->topology[k], with_centre);
    return count + (model->cpgs > 1 ? model->cpgs : 0);
}

static twd_num in_range(twd_num parameter, twd_num lower, twd_num upper)
{
    return lower + twd_mul(parameter, upper - lower);
}

/* Read one CPG's parameters, its frequency aside; returns where the next one's start. */
static const twd_num *decode_cpg(const struct twd_topology *topology, bool with_centre,
                                 const struct twd_parameter_ranges *ranges, const twd_num *parameter,
                                 struct twd_cpg_drive *drive)
{
    if (topology->chooses_frequency) parameter++;
    for (uint8_t i = 0; i < topology->oscillators; i++)
        drive->amplitude[i] = in_range(*parameter++, TWD_NUM(0), ranges->amplitude_upper);
    if (with_centre)
        for (uint8_t i = 0; i < topology->oscillators; i++)
            drive->centre[i] = in_range(*parameter++, ranges->centre_lower, ranges->centre_upper);
    for (uint8_t k = 0; k < topology->couplings; k++)
        drive->phase_lag[k] = twd_phase_from_fraction(*parameter++);
    return parameter;
}

/* The frequency that all CPGs share. */
static twd_num decode_frequency(const struct twd_model *model, bool with_centre,
                                const struct twd_parameter_ranges *ranges, const twd_num *parameter)
{
    for (uint8_t k = 0; k < model->cpgs; k++) {
        const struct twd_topology *const topology = model->topology[k];
        if (topology->chooses_frequency)
            return in_range(*parameter, ranges->frequency_lower_hz, ranges->frequency_upper_hz);
        parameter += topology_parameters(topology, with_centre);
    }
    return ranges->lone_frequency_hz;
}

enum twd_error twd_model_decode(const struct twd_model *model, bool with_centre,
                                const struct twd_parameter_ranges *ranges, const twd_num *parameter, size_t count,
                                struct twd_model_drive *drive)
{
    static const struct twd_model_drive nothing = {{{TWD_NUM(0), {TWD_NUM(0)}, {TWD_NUM(0)}, {0}}}, {TWD_NUM(0)}};

    if (count != twd_model_parameters(model, with_centre)) return TWD_ERROR_PARAMETER_COUNT;
    for (size_t i = 0; i < count; i++)
        if (!twd_within(parameter[i], TWD_NUM(0), TWD_NUM(1))) return TWD_ERROR_PARAMETER;

    *drive = nothing;
    const twd_num frequency_hz = decode_frequency(model, with_centre, ranges, parameter);
    for (uint8_t k = 0; k < model->cpgs; k++) {
        drive->cpg[k].frequency_hz = frequency_hz;
        parameter = decode_cpg(model->topology[k], with_centre, ranges, parameter, &drive->cpg[k]);
    }

    drive->weight[0] = TWD_NUM(1);
    if (model->cpgs > 1) twd_gate_normalise(parameter, model->cpgs, drive->weight);
    return TWD_OK;
}
