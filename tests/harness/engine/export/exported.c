#include "exported.h"

#define RUN(number, kind)                                                                                              \
    {                                                                                                                  \
#number, #number "_" #kind, &number##_##kind##_skill, &number##_##kind##_learner,                              \
            number##_##kind##_reward_per_rad                                                                           \
    }

struct exported exported_in_c(int run)
{
    const struct exported all[EXPORTED_RUNS] = {RUN(float, plain), RUN(double, plain), RUN(fixed, plain),
                                                RUN(float, odd),   RUN(double, odd),   RUN(fixed, odd)};
    return all[run];
}
