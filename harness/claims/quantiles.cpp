#include "quantiles.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace twiddle::claims
{

double student_quantile(double degrees, double share)
{
    return boost::math::quantile(boost::math::students_t(degrees), share);
}

double normal_quantile(double share)
{
    return boost::math::quantile(boost::math::normal(), share);
}

} // namespace twiddle::claims
