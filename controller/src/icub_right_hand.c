/* Written by twiddle-hand-tables from models/icub_right_hand.urdf (`make hand-tables`); change it there. */
#include <twiddle/icub_right_hand.h>

/* clang-format off */

const struct twd_joint_range twd_icub_joint_range[TWD_ICUB_JOINTS] = {
    [TWD_ICUB_FEI] = {TWD_NUM(0), TWD_NUM(1.5707963)}, /* index_1 */
    [TWD_ICUB_AAI] = {TWD_NUM(-0.2617993877991494), TWD_NUM(0.2617993877991494)}, /* index_0 */
    [TWD_ICUB_FET] = {TWD_NUM(0), TWD_NUM(1.5707963)}, /* thumb_1 */
    [TWD_ICUB_OT] = {TWD_NUM(0), TWD_NUM(2.2689280275926285)}, /* thumb_0 */
};

static const struct twd_chain_joint index_joint[] = {
    /* index_0 */
    {.rotation = {{TWD_NUM(-0.9450193510907932), TWD_NUM(-0.32623547104701534), TWD_NUM(-0.022557559590269893)},
                  {TWD_NUM(-0.006231412860404489), TWD_NUM(0.08693268980620161), TWD_NUM(-0.9961946983079272)},
                  {TWD_NUM(0.3269550359876717), TWD_NUM(-0.9412827018881155), TWD_NUM(-0.08418598201903649)}},
     .origin_m = {TWD_NUM(-0.0525584344), TWD_NUM(0.0051432), TWD_NUM(0.0394733411)},
     .mass_kg = TWD_NUM(0.004672176594),
     .centre_of_mass_m = {TWD_NUM(0.0074), TWD_NUM(0), TWD_NUM(0)}},
    /* index_1 */
    {.rotation = {{TWD_NUM(1), TWD_NUM(0), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM(-3.2051032938795743e-09), TWD_NUM(-1)},
                  {TWD_NUM(0), TWD_NUM(1), TWD_NUM(-3.2051032938795743e-09)}},
     .origin_m = {TWD_NUM(0.0148), TWD_NUM(0.00175), TWD_NUM(0)},
     .mass_kg = TWD_NUM(0.006882169216),
     .centre_of_mass_m = {TWD_NUM(0.01295), TWD_NUM(0), TWD_NUM(0)}},
    /* index_2 */
    {.rotation = {{TWD_NUM(1), TWD_NUM(0), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM(1), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM(0), TWD_NUM(1)}},
     .origin_m = {TWD_NUM(0.0259), TWD_NUM(0), TWD_NUM(0)},
     .mass_kg = TWD_NUM(0.006105685322),
     .centre_of_mass_m = {TWD_NUM(0.011), TWD_NUM(0), TWD_NUM(0)}},
    /* index_3 */
    {.rotation = {{TWD_NUM(1), TWD_NUM(0), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM(1), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM(0), TWD_NUM(1)}},
     .origin_m = {TWD_NUM(0.022), TWD_NUM(0), TWD_NUM(0)},
     .mass_kg = TWD_NUM(0.005070373463),
     .centre_of_mass_m = {TWD_NUM(0.0084), TWD_NUM(0), TWD_NUM(0)}},
};

const struct twd_chain twd_icub_index = {.joints = 4, .joint = index_joint};

static const struct twd_chain_joint thumb_joint[] = {
    /* thumb_0 */
    {.rotation = {{TWD_NUM(-0.2409796755513416), TWD_NUM(-0.08021574958845765), TWD_NUM(0.9672095065130056)},
                  {TWD_NUM(0.04031193200529612), TWD_NUM(-0.9965457604675163), TWD_NUM(-0.07260506478352434)},
                  {TWD_NUM(0.9696926028949434), TWD_NUM(0.021493738906510473), TWD_NUM(0.2433809258726909)}},
     .origin_m = {TWD_NUM(-0.0318492128), TWD_NUM(-0.0040568), TWD_NUM(0.0192026964)},
     .mass_kg = TWD_NUM(0.005926496731),
     .centre_of_mass_m = {TWD_NUM(0.01055), TWD_NUM(0), TWD_NUM(0)}},
    /* thumb_1 */
    {.rotation = {{TWD_NUM(1), TWD_NUM(-0), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM(-3.2051032938795743e-09), TWD_NUM(1)},
                  {TWD_NUM(-0), TWD_NUM(-1), TWD_NUM(-3.2051032938795743e-09)}},
     .origin_m = {TWD_NUM(0.0211), TWD_NUM(0.0049), TWD_NUM(0)},
     .mass_kg = TWD_NUM(0.00690207906),
     .centre_of_mass_m = {TWD_NUM(0.013), TWD_NUM(0), TWD_NUM(0)}},
    /* thumb_2 */
    {.rotation = {{TWD_NUM(1), TWD_NUM(0), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM(1), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM(0), TWD_NUM(1)}},
     .origin_m = {TWD_NUM(0.026), TWD_NUM(0), TWD_NUM(0)},
     .mass_kg = TWD_NUM(0.006105685322),
     .centre_of_mass_m = {TWD_NUM(0.011), TWD_NUM(0), TWD_NUM(0)}},
    /* thumb_3 */
    {.rotation = {{TWD_NUM(1), TWD_NUM(0), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM(1), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM(0), TWD_NUM(1)}},
     .origin_m = {TWD_NUM(0.022), TWD_NUM(0), TWD_NUM(0)},
     .mass_kg = TWD_NUM(0.005070373463),
     .centre_of_mass_m = {TWD_NUM(0.0084), TWD_NUM(0), TWD_NUM(0)}},
};

const struct twd_chain twd_icub_thumb = {.joints = 4, .joint = thumb_joint};
