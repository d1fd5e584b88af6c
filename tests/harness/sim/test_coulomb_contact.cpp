// One contact, solved exactly: the laws of Signorini and Coulomb are the expected values.
#include "sim/coulomb_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace twiddle::sim
{

namespace
{

// W = J M^-1 J^T of a finger of two joints, a hinge and random Jacobians: rank 3, often badly conditioned, as in use.
ContactMatrix random_inverse_mass(std::mt19937_64 &random)
{
    std::normal_distribution<double> normal;
    ContactMatrix w{};
    for (int joint = 0; joint < 3; joint++) {
        const double strength = std::exp(2 * normal(random));
        const ContactVector jacobian = {normal(random), normal(random), normal(random)};
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++)
                w[i][j] += strength * jacobian[i] * jacobian[j];
        }
    }
    return w;
}

ContactVector velocity(const ContactMatrix &w, const ContactVector &p, const ContactVector &b)
{
    ContactVector u = b;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            u[i] += w[i][j] * p[j];
    }
    return u;
}

// Whether mu is small enough for the contact never to jam: the normal velocity then grows with the normal impulse in
// every direction of slip, and the laws have one answer.
bool has_one_answer(const ContactMatrix &w, double friction)
{
    return w[0][0] > friction * std::hypot(w[0][1], w[0][2]);
}

} // namespace

// Over 10,000 random contacts the impulse is within the cone, does not pull, lets nothing approach, and either sticks
// or opposes the slip at full friction. Expected: the laws, term by term.
TEST(CoulombContact, obeys_signorini_and_coulomb)
{
    constexpr unsigned seed = 3;
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    int sliding = 0, sticking = 0, apart = 0;
    for (int i = 0; i < 10000; i++) {
        const ContactMatrix w = random_inverse_mass(random);
        const double friction = std::uniform_real_distribution<double>(0, 1)(random);
        if (!has_one_answer(w, friction)) continue;
        const double slip_share =
            i % 2 == 0 ? 1 : 0.1; // every other contact comes slowly along the surface, and may stick
        const ContactVector b = {normal(random), slip_share * normal(random), slip_share * normal(random)};
        double multiplier = i % 3 == 0 ? 0 : std::exp(10 * normal(random)) * w[1][1]; // any first guess will do
        const ContactVector p = CoulombContact(w, friction).solve(b, multiplier);
        const ContactVector u = velocity(w, p, b);
        const double scale = std::max({std::abs(b[0]), std::abs(b[1]), std::abs(b[2])});
        const double tangential = std::hypot(p[1], p[2]), slip = std::hypot(u[1], u[2]);
        const double cone_tolerance = 2e-10 * std::abs(b[0]) / w[0][0]; // as the header promises, and rounding
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", case " << i);

        ASSERT_GE(p[0], 0);
        ASSERT_GE(u[0], -1e-8 * scale);
        ASSERT_LE(tangential, friction * p[0] + cone_tolerance);
        if (p[0] == 0) {
            apart++;
            continue;
        }
        ASSERT_NEAR(u[0], 0, 1e-7 * scale);
        if (slip < 1e-7 * scale) {
            sticking++;
            continue;
        }
        sliding++;
        ASSERT_NEAR(tangential, friction * p[0], cone_tolerance);
        // Opposite: the sine of the angle between impulse and slip is 0 and their product is negative.
        ASSERT_LT(p[1] * u[1] + p[2] * u[2], 0);
        ASSERT_LT(std::abs(p[1] * u[2] - p[2] * u[1]), 1e-6 * tangential * slip + 1e-9 * tangential * scale);
    }
    std::printf("%d sliding, %d sticking, %d apart\n", sliding, sticking, apart);
    EXPECT_GT(sliding, 100) << "too few cases to say anything";
    EXPECT_GT(sticking, 100) << "too few cases to say anything";
    EXPECT_GT(apart, 100) << "too few cases to say anything";
}

// A unit mass that slides along x and is pressed down: p_n stops the approach, p_t is mu p_n against the slip. By hand.
TEST(CoulombContact, slides_and_sticks_as_worked_by_hand)
{
    const ContactMatrix unit = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const CoulombContact contact(unit, 0.5);
    const ContactVector sliding = contact.solve({-2, 3, 4});
    EXPECT_NEAR(sliding[0], 2, 1e-9);
    EXPECT_NEAR(sliding[1], -0.6, 1e-9);
    EXPECT_NEAR(sliding[2], -0.8, 1e-9);
    const ContactVector sticking = contact.solve({-2, 0.3, 0.4});
    EXPECT_NEAR(sticking[0], 2, 1e-12);
    EXPECT_NEAR(sticking[1], -0.3, 1e-12);
    EXPECT_NEAR(sticking[2], -0.4, 1e-12);
    const ContactVector apart = contact.solve({0.1, 3, 4});
    EXPECT_EQ(apart, (ContactVector{0, 0, 0}));
}

} // namespace twiddle::sim
