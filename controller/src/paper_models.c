#include <twiddle/model.h>

const struct twd_model twd_model_c = {.name = "cpg-c", .cpgs = 1, .topology = {&twd_cpg_c}};
const struct twd_model twd_model_m = {.name = "cpg-m", .cpgs = 1, .topology = {&twd_cpg_m}};
const struct twd_model twd_model_s = {.name = "cpg-s", .cpgs = 1, .topology = {&twd_cpg_s}};
const struct twd_model twd_model_h = {.name = "cpg-h", .cpgs = 3, .topology = {&twd_cpg_c, &twd_cpg_m, &twd_cpg_s}};
