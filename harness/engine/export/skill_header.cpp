#include "skill_header.hpp"

#include "c_text.hpp"
#include "engine/controller_setup.hpp"
#include "engine/engine.hpp"
#include "engine/library_models.hpp"
#include "record/versions.hpp"
#include "settings/constants.hpp"
#include "settings/setup.hpp"
#include "sim/object.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace twiddle::engine
{

namespace
{

using namespace TWD_BUILD_NAMESPACE; // names and counts alone, which are the same in every build

using Fields = std::map<std::string, std::string>;

// The header, with the fields that the functions below fill. Structs are written without their fields' names, which
// C++17 does not know; the order is that of the library's headers.
constexpr const char *layout =
    R"(/* @skill@: learned in @trials@ trials from seed @seed@.
 *
 * @source@; written by `twiddle export` of twiddle @version@.
 * Make it anew rather than change it.
 *
 *     to play it          twd_skill_start with @name@_skill
 *     to go on learning   twd_learner_restore with @name@_learner
 *
 * A program takes no memory for what it does not use of this.@beyond@ */
#ifndef @guard@
#define @guard@

#include <twiddle/icub_right_hand.h>
#include <twiddle/learner.h>
#include <twiddle/skill.h>

/* clang-format off */

/* What was learned, without noise: each in (0, 1). */
static const twd_num @name@_parameter[@units@] = {
@parameters@};

/* Stiffness, N m/rad; damping, N m s/rad; torque limit, N m; inertia, kg m2, where gains are to be made stable. */
static const struct twd_joint_setup @name@_joint[TWD_ICUB_JOINTS] = {
@joints@};

/* The first two joints of a finger move; the others are held, rad. */
static const struct twd_finger_setup @name@_finger[2] = {
    {
        &twd_icub_index, 2,
        {TWD_ICUB_AAI, TWD_ICUB_FEI},
        {@index_distal@, @index_distal@},
    },
    {
        &twd_icub_thumb, 2,
        {TWD_ICUB_OT, TWD_ICUB_FET},
        {@thumb_distal@, @thumb_distal@},
    },
};

static const struct twd_skill @name@_skill = {
    {
        &@model@,
        {
            @with_centre@,
            @tick@, /* tick, s */
            @amplitude_rate@, @centre_rate@, /* filters' rates, 1/s */
            @return_lag@, @centre_start@,
        },
        @phase_start@, @saturation@,
        {
            @frequency_lower@, @frequency_upper@, /* frequency, Hz */
            @lone_frequency@,
            @amplitude_upper@,
            @centre_lower@, @centre_upper@, /* centre */
        },
        @torque_period@, /* torque period, s */
        TWD_ICUB_JOINTS, twd_icub_joint_range, @name@_joint,
        2, @name@_finger,
        @gravity@, /* m/s2 */
        {
            @down_x@,
            @down_y@,
            @down_z@,
        },
    },
    @trial_ticks@, /* ticks of a trial */
    @units@, @name@_parameter,
};

/* The actor's weights, [units][inputs]. */
static const twd_num @name@_actor_weight[@actor_weights@] = {
@actor@};

/* The critic's weights, [inputs]. */
static const twd_wide @name@_critic_weight[@inputs@] = {
@critic@};

/* What the learner sees of @object@, [inputs]. */
static const twd_num @name@_input[@inputs@] = {
@input@};

static const struct twd_learner_snapshot @name@_learner = {
    {
        @units@, @inputs@,
        @actor_rate@, @critic_rate@,
        @weight_range@, @clip@,
        {
            @noise_start@, @noise_end@,
            @noise_decay@, UINT32_C(@trials@),
        },
        @silent_units@, @learned_value@, UINT64_C(@seed@),
    },
    {{@random_state@}},
    UINT32_C(@trials_learned@), /* trials learned from */
    @name@_actor_weight, @name@_critic_weight, @name@_input,
};

/* What a rotation of 1 rad was worth to it. */
static const twd_wide @name@_reward_per_rad = @reward_per_rad@;

#endif
)";

// Makes constants, and remembers one that the fixed build's formats do not reach.
class Constants
{
  public:
    std::string operator()(CType type, double value)
    {
        const std::string text = c_constant(type, value);
        if (!fixed_build_reaches(type, value)) beyond_ = text;
        return text;
    }

    std::string list(CType type, const std::vector<double> &values)
    {
        std::vector<std::string> texts;
        std::transform(values.begin(), values.end(), std::back_inserter(texts),
                       [&](double value) { return (*this)(type, value); });
        return c_list(texts, "    ");
    }

    // Empty if all were reached.
    const std::string &beyond() const
    {
        return beyond_;
    }

  private:
    std::string beyond_;
};

void add_names(Fields &fields, const std::string &name, const record::RunSpecification &run)
{
    std::string guard = "TWIDDLE_SKILL_" + name + "_H";
    std::transform(guard.begin(), guard.end(), guard.begin(), [](unsigned char c) { return std::toupper(c); });
    fields["name"] = name;
    fields["guard"] = guard;
    fields["object"] = c_comment_text(run.object);
    fields["skill"] = run.model + (run.centre ? " with centre" : " without centre") + " turns " + fields["object"];
    fields["source"] = c_comment_text("Set-up " + run.setup + ", stepper " + run.stepper + ", hand " + run.hand +
                                      ", number type " + run.number);
    fields["version"] = record::version();
    fields["trials"] = std::to_string(run.trials);
    fields["seed"] = std::to_string(run.seed);
}

void add_hand(Fields &fields, const settings::HandSetup &hand, Constants &constant)
{
    for (std::size_t i = 0; i < joint_count; ++i) {
        const double inertia = hand.pd_law == settings::PdLaw::stable ? hand.pd_inertia_kg_m2[i] : 0;
        fields["joints"] += std::string("    /* ") + joint_names[i] + " */\n    {{" +
                            constant(CType::num, hand.stiffness_nm_per_rad[i]) + ", " +
                            constant(CType::num, hand.damping_nms_per_rad[i]) + ", " +
                            constant(CType::num, hand.torque_limit_nm) + "},\n     " + constant(CType::small, inertia) +
                            "},\n";
    }
    fields["index_distal"] = constant(CType::num, hand.index_distal_deg * rad_per_deg);
    fields["thumb_distal"] = constant(CType::num, hand.thumb_distal_deg * rad_per_deg);
}

void add_oscillators(Fields &fields, const settings::OscillatorSetup &setup, Constants &constant)
{
    const std::map<settings::CentreStart, std::string> starts = {
        {settings::CentreStart::hand, "TWD_CENTRE_START_AT_TOPOLOGY"},
        {settings::CentreStart::zero, "TWD_CENTRE_START_AT_ZERO"},
        {settings::CentreStart::target, "TWD_CENTRE_START_AT_TARGET"}};
    const bool equal_lag = setup.return_lag == settings::ReturnLag::equal;
    const bool starts_at_zero = setup.phase_start == settings::PhaseStart::zero;
    const bool saturates_each = setup.saturation == settings::Saturation::each;
    fields["tick"] = constant(CType::small, control_step_s);
    fields["amplitude_rate"] = constant(CType::rate, setup.amplitude_rate_per_s);
    fields["centre_rate"] = constant(CType::rate, setup.centre_rate_per_s);
    fields["return_lag"] = equal_lag ? "TWD_RETURN_LAG_EQUAL" : "TWD_RETURN_LAG_NEGATED";
    fields["centre_start"] = starts.at(setup.centre_start);
    fields["phase_start"] = starts_at_zero ? "TWD_PHASE_START_AT_ZERO" : "TWD_PHASE_START_AT_LAG";
    fields["saturation"] = saturates_each ? "TWD_SATURATE_EACH" : "TWD_SATURATE_SUM";
    fields["frequency_lower"] = constant(CType::num, setup.frequency_lower_hz);
    fields["frequency_upper"] = constant(CType::num, setup.frequency_upper_hz);
    fields["lone_frequency"] = constant(CType::num, setup.lone_frequency_hz);
    fields["amplitude_upper"] = constant(CType::num, setup.amplitude_upper);
    fields["centre_lower"] = constant(CType::num, setup.centre_lower);
    fields["centre_upper"] = constant(CType::num, setup.centre_upper);
}

void add_physics(Fields &fields, const settings::PhysicsSetup &setup, Constants &constant)
{
    fields["torque_period"] = constant(CType::small, control_step_s / setup.substeps);
    fields["trial_ticks"] = std::to_string(trial_steps);
    fields["gravity"] = constant(CType::wide, setup.gravity_m_s2);
    fields["down_x"] = constant(CType::num, setup.gravity_direction[0]);
    fields["down_y"] = constant(CType::num, setup.gravity_direction[1]);
    fields["down_z"] = constant(CType::num, setup.gravity_direction[2]);
}

void add_learner(Fields &fields, const settings::LearnerSetup &setup, const twd_learner_config &config,
                 Constants &constant)
{
    const bool unclipped = setup.learned_value == settings::LearnedValue::unclipped;
    fields["units"] = std::to_string(config.units);
    fields["inputs"] = std::to_string(config.inputs);
    fields["actor_rate"] = constant(CType::num, setup.actor_rate);
    fields["critic_rate"] = constant(CType::num, setup.critic_rate);
    fields["weight_range"] = constant(CType::num, setup.weight_range);
    fields["clip"] = constant(CType::num, setup.clip);
    fields["noise_start"] = constant(CType::num, setup.noise_start);
    fields["noise_end"] = constant(CType::num, setup.noise_end);
    fields["noise_decay"] = constant(CType::num, setup.noise_decay_fraction);
    fields["silent_units"] = std::to_string(config.silent_units);
    fields["learned_value"] = unclipped ? "TWD_LEARN_FROM_UNCLIPPED" : "TWD_LEARN_FROM_CLIPPED";
    fields["reward_per_rad"] = constant(CType::wide, setup.reward_per_rad);
}

void add_learned(Fields &fields, const record::Policy &policy, Constants &constant)
{
    for (const auto &[parameter, value] : policy.parameters) {
        fields["parameters"] += "    " + constant(CType::num, value) + ", /* " + parameter + " */\n";
    }
    std::vector<double> actor;
    for (const std::vector<double> &unit : policy.actor_weights) {
        actor.insert(actor.end(), unit.begin(), unit.end());
    }
    fields["actor_weights"] = std::to_string(actor.size());
    fields["actor"] = constant.list(CType::num, actor);
    fields["critic"] = constant.list(CType::wide, policy.critic_weights);
    for (const std::uint32_t word : policy.random_state) {
        std::string &state = fields["random_state"];
        state += (state.empty() ? "UINT32_C(" : ", UINT32_C(") + std::to_string(word) + ")";
    }
    fields["trials_learned"] = std::to_string(policy.trials);
}

} // namespace

std::string skill_name(const record::RunSpecification &specification)
{
    std::string name = specification.object + "_" + specification.model + (specification.centre ? "" : "_no_centre");
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

std::string skill_header(const std::string &name, const record::RunSpecification &specification,
                         const record::Policy &policy, const std::filesystem::path &models_dir)
{
    const settings::Setup setup =
        settings::setup_from_settings(specification.settings, specification.setup, "the run's settings");
    Fields fields;
    Constants constant;
    add_names(fields, name, specification);
    add_hand(fields, setup.hand, constant);
    add_oscillators(fields, setup.oscillators, constant);
    add_physics(fields, setup.physics, constant);
    const AgentSetup agent = {
        {setup, specification.model, specification.centre}, specification.trials, specification.seed};
    add_learner(fields, setup.learner, learner_config(agent), constant);
    add_learned(fields, policy, constant);
    // To the last bit what the run's own number type computes.
    const Engine &engine = engine_of_number(specification.number);
    const sim::ObjectSpec object = sim::read_object(models_dir, specification.object);
    fields["input"] = constant.list(CType::num, engine.learner_input(object, setup.learner));
    fields["model"] = find_library_model(specification.model).c_name;
    fields["with_centre"] = specification.centre ? "true" : "false";
    fields["beyond"] = "";
    if (!constant.beyond().empty())
        fields["beyond"] =
            "\n *\n * The fixed build's types do not reach all of these numbers, which are at their ends there: such "
            "as\n * " +
            constant.beyond() + ".";
    return fill(layout, fields);
}

} // namespace twiddle::engine
