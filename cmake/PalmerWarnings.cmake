# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
# One target carries what every translation unit of the project is compiled with.
add_library(palmer_options INTERFACE)
target_compile_options(palmer_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Woverloaded-virtual
    -ffp-contract=off) # published numbers are the same on every CPU
if(PALMER_WARNINGS_AS_ERRORS)
    target_compile_options(palmer_options INTERFACE -Werror)
endif()
target_compile_definitions(palmer_options INTERFACE QT_NO_CAST_FROM_ASCII QT_NO_FOREACH)
