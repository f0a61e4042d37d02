#pragma once
// Measures that several links share [m].
namespace heft::panda_maker {

constexpr double kTube = 0.0550;                     ///< Radius of the arm's tubes and joint housings.
constexpr double kWrist = 0.0475;                    ///< Radius of the housings of joint 6.
constexpr double kHalfGap = 0.00050;                 ///< Half the groove between two links.
constexpr double kGrooveDepth = 0.0008;              ///< How far the dark ring lies below the shells.
constexpr double kSeam01 = 0.1410;                   ///< Height of the seam between base and link 1, in link 0.
constexpr double kSeam45 = 0.1245;                   ///< Seam between links 4 and 5 along link 4's y.
constexpr double kSeam56 = 0.0160;                   ///< Seam between links 5 and 6 along link 5's y,
constexpr double kSeam56Link6 = -0.0160 + kHalfGap;  ///< and along link 6's z.
constexpr double kCoarse = 0.0072;                   ///< Grid of the large smooth shells.

}  // namespace heft::panda_maker
