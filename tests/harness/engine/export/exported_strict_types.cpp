#include <double_odd.h>
#include <double_plain.h>
#include <fixed_odd.h>
#include <fixed_plain.h>
#include <float_odd.h>
#include <float_plain.h>
