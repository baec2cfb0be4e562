#pragma once

namespace tank_datum {

constexpr double kNormal95 = 1.959963984540054;  ///< two-sided 95 % point of the normal distribution

}  // namespace tank_datum
