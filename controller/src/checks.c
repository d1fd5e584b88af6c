#include "checks.h"

static bool is_filter_rate(twd_rate rate_per_s, twd_small tick_s)
{
    return rate_per_s > TWD_RATE(0) && twd_num_mul_rate_small(rate_per_s, tick_s) <= TWD_LARGEST_RATE_TIMES_TICK;
}

static bool has_tables(const struct twd_topology *topology)
{
    if (!topology || !topology->joint_oscillator || !topology->initial_centre) return false;
    return topology->coupling || topology->couplings == 0;
}

static enum twd_error check_topology(const struct twd_topology *topology)
{
    if (!has_tables(topology)) return TWD_ERROR_NULL;
    if (topology->oscillators < 1 || topology->oscillators > TWD_MAX_OSCILLATORS) return TWD_ERROR_TOO_MANY_OSCILLATORS;
    if (topology->couplings > TWD_MAX_COUPLINGS) return TWD_ERROR_TOO_MANY_COUPLINGS;
    if (topology->joints < 1 || topology->joints > TWD_MAX_JOINTS) return TWD_ERROR_TOO_MANY_JOINTS;

    for (uint8_t k = 0; k < topology->couplings; k++) {
        const struct twd_coupling coupling = topology->coupling[k];
        if (coupling.first >= topology->oscillators || coupling.second >= topology->oscillators)
            return TWD_ERROR_COUPLING;
        if (coupling.first == coupling.second) return TWD_ERROR_COUPLING;
    }
    for (uint8_t j = 0; j < topology->joints; j++)
        if (topology->joint_oscillator[j] >= topology->oscillators) return TWD_ERROR_JOINT_OSCILLATOR;
    for (uint8_t i = 0; i < topology->oscillators; i++)
        if (!twd_within(topology->initial_centre[i], TWD_NUM(0), TWD_NUM(1))) return TWD_ERROR_RANGE;
    return TWD_OK;
}

static enum twd_error check_cpg_config(const struct twd_cpg_config *config)
{
    const twd_small tick_s = config->tick_s;
    if (!(tick_s > TWD_SMALL(0)) || tick_s > TWD_SMALL(0.1)) return TWD_ERROR_TICK;
    if (!is_filter_rate(config->amplitude_rate_per_s, tick_s)) return TWD_ERROR_RANGE;
    if (!is_filter_rate(config->centre_rate_per_s, tick_s)) return TWD_ERROR_RANGE;
    if (config->return_lag != TWD_RETURN_LAG_NEGATED && config->return_lag != TWD_RETURN_LAG_EQUAL)
        return TWD_ERROR_RANGE;
    if (config->centre_start != TWD_CENTRE_START_AT_TOPOLOGY && config->centre_start != TWD_CENTRE_START_AT_ZERO &&
        config->centre_start != TWD_CENTRE_START_AT_TARGET)
        return TWD_ERROR_RANGE;
    return TWD_OK;
}

enum twd_error twd_check_cpgs(const struct twd_topology *const *topology, size_t networks,
                              const struct twd_cpg_config *config)
{
    unsigned oscillators = 0;
    unsigned couplings = 0;
    if (networks < 1 || networks > TWD_MAX_CPGS) return TWD_ERROR_TOO_MANY_CPGS;
    for (size_t n = 0; n < networks; n++) {
        const enum twd_error error = check_topology(topology[n]);
        if (error != TWD_OK) return error;
        oscillators += topology[n]->oscillators;
        couplings += topology[n]->couplings;
    }
    if (oscillators > TWD_MAX_OSCILLATORS) return TWD_ERROR_TOO_MANY_OSCILLATORS;
    if (couplings > TWD_MAX_COUPLINGS) return TWD_ERROR_TOO_MANY_COUPLINGS;
    return check_cpg_config(config);
}

static enum twd_error check_model(const struct twd_controller_config *config)
{
    const struct twd_model *const model = config->model;
    if (!model) return TWD_ERROR_NULL;
    const enum twd_error error = twd_check_cpgs(model->topology, model->cpgs, &config->oscillators);
    if (error != TWD_OK) return error;
    for (uint8_t k = 0; k < model->cpgs; k++)
        if (model->topology[k]->joints != config->joints) return TWD_ERROR_TOO_MANY_JOINTS;
    return TWD_OK;
}

static enum twd_error check_ranges(const struct twd_parameter_ranges *ranges)
{
    const twd_num fastest_hz = TWD_NUM(5);
    if (!(ranges->frequency_lower_hz > TWD_NUM(0))) return TWD_ERROR_RANGE;
    if (!twd_within(ranges->frequency_upper_hz, ranges->frequency_lower_hz, fastest_hz)) return TWD_ERROR_RANGE;
    if (!(ranges->lone_frequency_hz > TWD_NUM(0)) || ranges->lone_frequency_hz > fastest_hz) return TWD_ERROR_RANGE;
    if (!(ranges->amplitude_upper > TWD_NUM(0)) || ranges->amplitude_upper > TWD_NUM(0.5)) return TWD_ERROR_RANGE;
    if (!(ranges->centre_lower >= TWD_NUM(0))) return TWD_ERROR_RANGE;
    if (!twd_within(ranges->centre_upper, ranges->centre_lower, TWD_NUM(1))) return TWD_ERROR_RANGE;
    return TWD_OK;
}

enum twd_error twd_check_pd(const struct twd_pd *pd)
{
    if (!(pd->stiffness_nm_per_rad > TWD_NUM(0)) || !twd_is_usable(pd->stiffness_nm_per_rad)) return TWD_ERROR_RANGE;
    if (!(pd->damping_nms_per_rad >= TWD_NUM(0)) || !twd_is_usable(pd->damping_nms_per_rad)) return TWD_ERROR_RANGE;
    if (!(pd->torque_limit_nm > TWD_NUM(0)) || !twd_is_usable(pd->torque_limit_nm)) return TWD_ERROR_RANGE;
    return TWD_OK;
}

static enum twd_error check_joint(const struct twd_joint *joint)
{
    const twd_num half_turn_rad = TWD_NUM_CONSTANT(3.14159265358979324, 843314857);
    if (!(joint->range.lower_rad >= -half_turn_rad) || !(joint->range.upper_rad <= half_turn_rad))
        return TWD_ERROR_RANGE;
    if (!(joint->range.lower_rad < joint->range.upper_rad)) return TWD_ERROR_RANGE;
    return twd_check_pd(&joint->pd);
}

static enum twd_error check_finger(const struct twd_finger *finger, uint8_t joints)
{
    if (finger->gravity.moving < 1 || finger->gravity.moving > TWD_MAX_CHAIN_JOINTS) return TWD_ERROR_CHAIN;
    for (uint8_t i = 0; i < finger->gravity.moving; i++)
        if (finger->joint[i] >= joints) return TWD_ERROR_CHAIN;
    return TWD_OK;
}

enum twd_error twd_check_config(const struct twd_controller_config *config)
{
    if (config->joints < 1 || config->joints > TWD_MAX_JOINTS) return TWD_ERROR_TOO_MANY_JOINTS;
    enum twd_error error = check_model(config);
    if (error == TWD_OK) error = check_ranges(&config->ranges);
    if (error != TWD_OK) return error;
    if (config->phase_start != TWD_PHASE_START_AT_LAG && config->phase_start != TWD_PHASE_START_AT_ZERO)
        return TWD_ERROR_RANGE;
    if (config->saturation != TWD_SATURATE_SUM && config->saturation != TWD_SATURATE_EACH) return TWD_ERROR_RANGE;

    for (uint8_t j = 0; j < config->joints; j++) {
        error = check_joint(&config->joint[j]);
        if (error != TWD_OK) return error;
    }
    if (config->fingers > TWD_MAX_CHAINS) return TWD_ERROR_CHAIN;
    for (uint8_t f = 0; f < config->fingers; f++) {
        error = check_finger(&config->finger[f], config->joints);
        if (error != TWD_OK) return error;
    }
    return TWD_OK;
}
