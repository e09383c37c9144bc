// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palmer {

/// If this process is a worker of another, keeps its standard output for the answers and redirects what is
/// printed to files that are taken with each answer. To be called before anything is printed.
void prepareAsWorker();

} // namespace palmer
