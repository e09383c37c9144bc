// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Included before finishpdf.cpp where clang compiles it: clang 14 makes the destructor of vector<JSON> inside
// of JSON, which is incomplete there. Nothing of ours destroys one.
#pragma once

#include <vector>

class JSON;
#pragma clang diagnostic ignored "-Wundefined-inline"
template <>
constexpr std::vector<JSON>::~vector() noexcept;
