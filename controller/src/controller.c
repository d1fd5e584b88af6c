#include <twiddle/controller.h>

#include "checks.h"
#include "four_joints.h"

static void count_one(uint32_t *counter)
{
    if (*counter < UINT32_MAX) (*counter)++;
}

enum twd_error twd_controller_init(struct twd_controller *controller, const struct twd_controller_config *config)
{
    static const struct twd_saturations none = {0, 0, 0};
    static const twd_num no_preference[TWD_MAX_CPGS] = {TWD_NUM(0)};

    const enum twd_error error = twd_check_config(config);
    if (error != TWD_OK) return error;

    if (config != &controller->config) controller->config = *config;
    config = &controller->config;
    /* The check above included this one's. */
    (void)twd_cpg_init_several(&controller->cpg, config->model->topology, config->model->cpgs, &config->oscillators);
    twd_gate_normalise(no_preference, config->model->cpgs, controller->weight);
    controller->saturations = none;
#if TWD_FOUR_AT_ONCE
    twd_four_joints_make(&controller->four, config);
    twd_four_joints_weigh(&controller->four, config->model, controller->weight);
#endif
    return TWD_OK;
}

enum twd_error twd_controller_start(struct twd_controller *controller, const twd_num *parameter, size_t count)
{
    const struct twd_controller_config *const config = &controller->config;
    struct twd_model_drive drive;
    const enum twd_error error =
        twd_model_decode(config->model, config->oscillators.with_centre, &config->ranges, parameter, count, &drive);
    if (error != TWD_OK) return error;

    twd_phase phase[TWD_MAX_OSCILLATORS] = {0};
    twd_phase *next = phase;
    for (uint8_t k = 0; k < config->model->cpgs; k++) {
        const struct twd_topology *const topology = config->model->topology[k];
        if (config->phase_start == TWD_PHASE_START_AT_LAG)
            twd_cpg_phases_at_lag(topology, drive.cpg[k].phase_lag, next);
        next += topology->oscillators;
        controller->weight[k] = drive.weight[k];
    }
    twd_cpg_start(&controller->cpg, drive.cpg, phase);
#if TWD_FOUR_AT_ONCE
    twd_four_joints_weigh(&controller->four, config->model, controller->weight);
#endif
    return TWD_OK;
}

/* `fraction` in [0, 1], and counted if it was not. */
static twd_num saturate(struct twd_controller *controller, twd_num fraction)
{
    if (!twd_within(fraction, TWD_NUM(0), TWD_NUM(1))) count_one(&controller->saturations.output);
    return twd_clamp(fraction, TWD_NUM(0), TWD_NUM(1));
}

/* Add the weighted outputs of one CPG, whose oscillators begin at `oscillator`, to the joints' sums. */
static void mix(struct twd_controller *controller, const struct twd_topology *topology,
                const struct twd_oscillator *oscillator, twd_num weight, twd_num *sum)
{
    twd_num weighted[TWD_MAX_OSCILLATORS];
    for (uint8_t i = 0; i < topology->oscillators; i++) {
        twd_num output = oscillator[i].output;
        if (controller->config.saturation == TWD_SATURATE_EACH) output = saturate(controller, output);
        weighted[i] = twd_mul_short(weight, output);
    }
    for (uint8_t j = 0; j < topology->joints; j++)
        sum[j] += weighted[topology->joint_oscillator[j]];
}

/* Advance the CPGs; whether that wrote the desired angles as well. */
static inline bool tick_cpgs(struct twd_controller *controller, twd_num *desired_angle_rad)
{
#if TWD_FOUR_AT_ONCE
    if (controller->four.fit && four_oscillators_fit(&controller->cpg)) {
        const struct twd_four fraction = four_joints_tick(&controller->four, &controller->cpg);
        return controller->config.saturation == TWD_SATURATE_SUM &&
               four_joints_angle(&controller->four, fraction, desired_angle_rad);
    }
#endif
    (void)desired_angle_rad;
    twd_cpg_tick(&controller->cpg);
    return false;
}

void twd_controller_tick(struct twd_controller *controller, twd_num *desired_angle_rad)
{
    const struct twd_controller_config *const config = &controller->config;
    twd_num sum[TWD_MAX_JOINTS] = {TWD_NUM(0)};

    if (tick_cpgs(controller, desired_angle_rad)) return;
    const struct twd_oscillator *oscillator = controller->cpg.oscillator;
    for (uint8_t k = 0; k < config->model->cpgs; k++) {
        const struct twd_topology *const topology = config->model->topology[k];
        mix(controller, topology, oscillator, controller->weight[k], sum);
        oscillator += topology->oscillators;
    }
    for (uint8_t j = 0; j < config->joints; j++) {
        const twd_num fraction = config->saturation == TWD_SATURATE_SUM ? saturate(controller, sum[j]) : sum[j];
        desired_angle_rad[j] = twd_joint_range_angle(&config->joint[j].range, fraction);
    }
}

/* Add the gravity torques of one finger to the joints'. A joint without a usable angle counts as straight, so that it
 * does not spoil the torques of the finger's other joints. */
static void add_gravity(const struct twd_finger *finger, const twd_num *angle_rad, twd_num *gravity_nm)
{
    twd_num finger_angle_rad[TWD_MAX_CHAIN_JOINTS];
    twd_num finger_nm[TWD_MAX_CHAIN_JOINTS];
    const size_t moving = finger->gravity.moving;
    for (size_t i = 0; i < moving; i++) {
        const twd_num angle = angle_rad[finger->joint[i]];
        finger_angle_rad[i] = twd_is_usable(angle) ? angle : TWD_NUM(0);
    }
    twd_gravity_torque(&finger->gravity, finger_angle_rad, finger_nm);
    for (size_t i = 0; i < moving; i++)
        gravity_nm[finger->joint[i]] = twd_add_saturated(gravity_nm[finger->joint[i]], finger_nm[i]);
}

/* twd_controller_torque, joint by joint. */
#if TWD_FOUR_AT_ONCE && defined(__GNUC__)
__attribute__((noinline)) /* so that the way past it saves no registers */
#endif
static void
find_torques(struct twd_controller *controller, const twd_num *desired_angle_rad, const twd_num *angle_rad,
             const twd_rate *velocity_rad_s, twd_num *torque_nm)
{
    const struct twd_controller_config *const config = &controller->config;
    twd_num gravity_nm[TWD_MAX_JOINTS] = {TWD_NUM(0)};
    const struct twd_finger *const end = config->finger + config->fingers;
    for (const struct twd_finger *finger = config->finger; finger < end; finger++)
        add_gravity(finger, angle_rad, gravity_nm);

    const size_t joints = config->joints;
    for (size_t j = 0; j < joints; j++) {
        if (!twd_is_usable(desired_angle_rad[j]) || !twd_is_usable(angle_rad[j]) ||
            !twd_rate_is_usable(velocity_rad_s[j])) {
            count_one(&controller->saturations.input);
            torque_nm[j] = TWD_NUM(0);
            continue;
        }
        const struct twd_pd *const pd = &config->joint[j].pd;
        torque_nm[j] = twd_pd_torque(pd, desired_angle_rad[j], angle_rad[j], velocity_rad_s[j], gravity_nm[j]);
        if (!twd_within(torque_nm[j], -pd->torque_limit_nm, pd->torque_limit_nm)) {
            torque_nm[j] = twd_clamp(torque_nm[j], -pd->torque_limit_nm, pd->torque_limit_nm);
            count_one(&controller->saturations.torque);
        }
    }
}

void twd_controller_torque(struct twd_controller *controller, const twd_num *desired_angle_rad,
                           const twd_num *angle_rad, const twd_rate *velocity_rad_s, twd_num *torque_nm)
{
#if TWD_FOUR_AT_ONCE
    if (controller->four.fit &&
        four_joints_torque(&controller->four, desired_angle_rad, angle_rad, velocity_rad_s, torque_nm))
        return;
#endif
    find_torques(controller, desired_angle_rad, angle_rad, velocity_rad_s, torque_nm);
}
