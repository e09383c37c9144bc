// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// ms that a test waits for what must come. Nothing is decided by the clock: a busy machine or a sanitizer
/// takes ten times as long, and ctest ends what hangs.
constexpr int patience = 1'200'000;
