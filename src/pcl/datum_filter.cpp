#include "tank_datum/pcl/datum_filter.h"

#include "tank_datum/pcl/impl/datum_filter.hpp"

namespace tank_datum {

template class DatumFilter<pcl::PointXYZ>;
template class DatumFilter<pcl::PointXYZI>;
template class DatumFilter<pcl::PointXYZRGB>;
template class DatumFilter<pcl::PointNormal>;

}  // namespace tank_datum
