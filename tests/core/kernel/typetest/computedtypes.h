// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Written by computedtypes.py.
#pragma once

#include <cstddef>
#include <vector>

namespace palmer::testdata {

struct ComputedFactor {
    std::size_t count;
    double content;
    double confidence;
    double factor;
};
// clang-format off
inline const std::vector<ComputedFactor> computedFactors{
    {3, 0.95, 0.95, 7.6559001331533425},
    {4, 0.95, 0.95, 5.1438748609893015},
    {5, 0.95, 0.95, 4.202680741256179},
    {10, 0.95, 0.95, 2.9109634130781674},
    {20, 0.95, 0.95, 2.39600168375217},
    {50, 0.95, 0.95, 2.0649934177439757},
    {100, 0.95, 0.95, 1.9265388505123155},
    {10, 0.9, 0.95, 2.3546401318290604},
    {10, 0.99, 0.95, 3.9811178452730602},
    {10, 0.95, 0.9, 2.5683732058891002},
    {40, 0.5, 0.99, 0.38355920485591766},
};

struct ComputedType {
    std::vector<double> values;
    double mean, s, normalLimit, logNormalLimit, w, probability, wOfLogarithms, probabilityOfLogarithms;
};
inline const std::vector<ComputedType> computedTypes{
    {{4.73, 7.52, 5.05, 3.59, 6.91, 3.7, 5.55, 6.14},
     5.39875, 1.4183535475029792, 9.9194591397413, 12.383501837092282, 0.9736061854513729, 0.9490293672240073, 0.9663897269640714, 0.8882011064577353},
    {{5.08, 4.05, 3.18, 4.12, 5.14, 5.0, 4.85, 9.1, 4.42, 4.45},
     4.939, 1.579363092445109, 9.536468178073704, 10.43079020667951, 0.695030304675224, 0.0023001055472358354, 0.8162736260273034, 0.025423563741382736},
    {{7.9, 8.94, 11.09, 11.36, 1.53, 7.4, 2.65, 2.97, 7.25, 5.58, 1.52, 1.72, 2.53, 3.34, 0.87, 3.06, 13.84, 3.36, 7.6, 3.99, 1.82, 2.58, 3.93, 12.49, 8.89},
     5.5284, 3.8559550049242017, 14.364995156730606, 24.80837511105533, 0.9053823368569088, 0.026094583097794336, 0.9639131204872805, 0.4228904979237484},
};
// clang-format on

} // namespace palmer::testdata
