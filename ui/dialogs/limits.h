// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer::ui {

inline constexpr int mostRuns = 1000; ///< each way, accepted by a dialog

} // namespace palmer::ui
