/* Written by twiddle-hand-tables from models/icub_right_hand.urdf (`make hand-tables`); change it there. */
#include <twiddle/icub_right_hand.h>

/* clang-format off */

const struct twd_joint_range twd_icub_joint_range[TWD_ICUB_JOINTS] = {
    /* index_1 */
    [TWD_ICUB_FEI] = {TWD_NUM(0), TWD_NUM_CONSTANT(1.5707963, 421657421)},
    /* index_0 */
    [TWD_ICUB_AAI] = {TWD_NUM_CONSTANT(-0.2617993877991494, -70276238), TWD_NUM_CONSTANT(0.2617993877991494, 70276238)},
    /* thumb_1 */
    [TWD_ICUB_FET] = {TWD_NUM(0), TWD_NUM_CONSTANT(1.5707963, 421657421)},
    /* thumb_0 */
    [TWD_ICUB_OT] = {TWD_NUM(0), TWD_NUM_CONSTANT(2.2689280275926285, 609060730)},
};

static const struct twd_chain_joint index_joint[] = {
    /* index_0 */
    {.rotation = {{TWD_NUM_CONSTANT(-0.9450193510907932, -253676700),
                   TWD_NUM_CONSTANT(-0.32623547104701534, -87573167),
                   TWD_NUM_CONSTANT(-0.022557559590269893, -6055249)},
                  {TWD_NUM_CONSTANT(-0.006231412860404489, -1672732),
                   TWD_NUM_CONSTANT(0.08693268980620161, 23335816),
                   TWD_NUM_CONSTANT(-0.9961946983079272, -267413978)},
                  {TWD_NUM_CONSTANT(0.3269550359876717, 87766324),
                   TWD_NUM_CONSTANT(-0.9412827018881155, -252673651),
                   TWD_NUM_CONSTANT(-0.08418598201903649, -22598502)}},
     .origin_m = {TWD_NUM_CONSTANT(-0.0525584344, -14108547),
                  TWD_NUM_CONSTANT(0.0051432, 1380617),
                  TWD_NUM_CONSTANT(0.0394733411, 10596044)},
     .mass_kg = TWD_NUM_CONSTANT(0.004672176594, 1254178),
     .centre_of_mass_m = {TWD_NUM_CONSTANT(0.0074, 1986422), TWD_NUM(0), TWD_NUM(0)}},
    /* index_1 */
    {.rotation = {{TWD_NUM(1), TWD_NUM(0), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM_CONSTANT(-3.2051032938795743e-09, -1), TWD_NUM(-1)},
                  {TWD_NUM(0), TWD_NUM(1), TWD_NUM_CONSTANT(-3.2051032938795743e-09, -1)}},
     .origin_m = {TWD_NUM_CONSTANT(0.0148, 3972845), TWD_NUM_CONSTANT(0.00175, 469762), TWD_NUM(0)},
     .mass_kg = TWD_NUM_CONSTANT(0.006882169216, 1847418),
     .centre_of_mass_m = {TWD_NUM_CONSTANT(0.01295, 3476239), TWD_NUM(0), TWD_NUM(0)}},
    /* index_2 */
    {.rotation = {{TWD_NUM(1), TWD_NUM(0), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM(1), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM(0), TWD_NUM(1)}},
     .origin_m = {TWD_NUM_CONSTANT(0.0259, 6952478), TWD_NUM(0), TWD_NUM(0)},
     .mass_kg = TWD_NUM_CONSTANT(0.006105685322, 1638982),
     .centre_of_mass_m = {TWD_NUM_CONSTANT(0.011, 2952790), TWD_NUM(0), TWD_NUM(0)}},
    /* index_3 */
    {.rotation = {{TWD_NUM(1), TWD_NUM(0), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM(1), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM(0), TWD_NUM(1)}},
     .origin_m = {TWD_NUM_CONSTANT(0.022, 5905580), TWD_NUM(0), TWD_NUM(0)},
     .mass_kg = TWD_NUM_CONSTANT(0.005070373463, 1361068),
     .centre_of_mass_m = {TWD_NUM_CONSTANT(0.0084, 2254858), TWD_NUM(0), TWD_NUM(0)}},
};

const struct twd_chain twd_icub_index = {.joints = 4, .joint = index_joint};

static const struct twd_chain_joint thumb_joint[] = {
    /* thumb_0 */
    {.rotation = {{TWD_NUM_CONSTANT(-0.2409796755513416, -64687489),
                   TWD_NUM_CONSTANT(-0.08021574958845765, -21532751),
                   TWD_NUM_CONSTANT(0.9672095065130056, 259633325)},
                  {TWD_NUM_CONSTANT(0.04031193200529612, 10821152),
                   TWD_NUM_CONSTANT(-0.9965457604675163, -267508216),
                   TWD_NUM_CONSTANT(-0.07260506478352434, -19489774)},
                  {TWD_NUM_CONSTANT(0.9696926028949434, 260299876),
                   TWD_NUM_CONSTANT(0.021493738906510473, 5769682),
                   TWD_NUM_CONSTANT(0.2433809258726909, 65332070)}},
     .origin_m = {TWD_NUM_CONSTANT(-0.0318492128, -8549458),
                  TWD_NUM_CONSTANT(-0.0040568, -1088989),
                  TWD_NUM_CONSTANT(0.0192026964, 5154685)},
     .mass_kg = TWD_NUM_CONSTANT(0.005926496731, 1590882),
     .centre_of_mass_m = {TWD_NUM_CONSTANT(0.01055, 2831994), TWD_NUM(0), TWD_NUM(0)}},
    /* thumb_1 */
    {.rotation = {{TWD_NUM(1), TWD_NUM(-0), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM_CONSTANT(-3.2051032938795743e-09, -1), TWD_NUM(1)},
                  {TWD_NUM(-0), TWD_NUM(-1), TWD_NUM_CONSTANT(-3.2051032938795743e-09, -1)}},
     .origin_m = {TWD_NUM_CONSTANT(0.0211, 5663988), TWD_NUM_CONSTANT(0.0049, 1315334), TWD_NUM(0)},
     .mass_kg = TWD_NUM_CONSTANT(0.00690207906, 1852763),
     .centre_of_mass_m = {TWD_NUM_CONSTANT(0.013, 3489661), TWD_NUM(0), TWD_NUM(0)}},
    /* thumb_2 */
    {.rotation = {{TWD_NUM(1), TWD_NUM(0), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM(1), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM(0), TWD_NUM(1)}},
     .origin_m = {TWD_NUM_CONSTANT(0.026, 6979322), TWD_NUM(0), TWD_NUM(0)},
     .mass_kg = TWD_NUM_CONSTANT(0.006105685322, 1638982),
     .centre_of_mass_m = {TWD_NUM_CONSTANT(0.011, 2952790), TWD_NUM(0), TWD_NUM(0)}},
    /* thumb_3 */
    {.rotation = {{TWD_NUM(1), TWD_NUM(0), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM(1), TWD_NUM(0)},
                  {TWD_NUM(0), TWD_NUM(0), TWD_NUM(1)}},
     .origin_m = {TWD_NUM_CONSTANT(0.022, 5905580), TWD_NUM(0), TWD_NUM(0)},
     .mass_kg = TWD_NUM_CONSTANT(0.005070373463, 1361068),
     .centre_of_mass_m = {TWD_NUM_CONSTANT(0.0084, 2254858), TWD_NUM(0), TWD_NUM(0)}},
};

const struct twd_chain twd_icub_thumb = {.joints = 4, .joint = thumb_joint};
