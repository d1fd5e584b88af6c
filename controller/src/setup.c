#include <twiddle/setup.h>

static enum twd_error make_joint(const struct twd_setup *setup, size_t index, struct twd_joint *joint)
{
    const struct twd_joint_setup *const from = &setup->joint[index];
    joint->range = setup->range[index];
    joint->pd = from->pd;
    if (from->inertia_kg_m2 == TWD_SMALL(0)) return TWD_OK;
    return twd_pd_stable(&from->pd, from->inertia_kg_m2, setup->torque_period_s, &joint->pd);
}

static enum twd_error make_finger(const struct twd_setup *setup, const struct twd_finger_setup *from,
                                  struct twd_finger *finger)
{
    for (size_t i = 0; i < TWD_MAX_CHAIN_JOINTS; i++)
        finger->joint[i] = from->joint[i];
    return twd_gravity_init(&finger->gravity, from->chain, from->moving, from->held_rad, setup->gravity_m_s2,
                            setup->gravity_direction);
}

static enum twd_error check(const struct twd_setup *setup)
{
    if (setup->joints > TWD_MAX_JOINTS) return TWD_ERROR_TOO_MANY_JOINTS;
    if (setup->joints > 0 && (!setup->range || !setup->joint)) return TWD_ERROR_NULL;
    if (setup->fingers > TWD_MAX_CHAINS) return TWD_ERROR_CHAIN;
    if (setup->fingers > 0 && !setup->finger) return TWD_ERROR_NULL;
    return TWD_OK;
}

enum twd_error twd_setup_config(const struct twd_setup *setup, struct twd_controller_config *config)
{
    enum twd_error error = check(setup);
    if (error != TWD_OK) return error;

    config->model = setup->model;
    config->oscillators = setup->oscillators;
    config->phase_start = setup->phase_start;
    config->saturation = setup->saturation;
    config->ranges = setup->ranges;
    config->joints = setup->joints;
    config->fingers = setup->fingers;
    for (uint8_t j = 0; j < setup->joints && error == TWD_OK; j++)
        error = make_joint(setup, j, &config->joint[j]);
    for (uint8_t f = 0; f < setup->fingers && error == TWD_OK; f++)
        error = make_finger(setup, &setup->finger[f], &config->finger[f]);
    return error;
}
