# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Windows x64 with the compilers that Debian packs. PALMER_STAGE is the folder of the libraries built before.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR AMD64)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES PALMER_STAGE)
if(NOT PALMER_STAGE)
    set(PALMER_STAGE $ENV{PALMER_STAGE})
endif()

set(prefix x86_64-w64-mingw32)
set(CMAKE_C_COMPILER ${prefix}-gcc-posix)
set(CMAKE_CXX_COMPILER ${prefix}-g++-posix)
set(CMAKE_RC_COMPILER ${prefix}-windres)
set(CMAKE_AR /usr/bin/${prefix}-gcc-ar-posix CACHE FILEPATH "")
set(CMAKE_RANLIB /usr/bin/${prefix}-gcc-ranlib-posix CACHE FILEPATH "")

# GCC does not align the stack of Win64 to the 32 bytes that aligned moves of AVX want.
set(CMAKE_C_FLAGS_INIT "-Wa,-muse-unaligned-vector-move")
set(CMAKE_CXX_FLAGS_INIT "-Wa,-muse-unaligned-vector-move")
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)

# Nothing of the machine that builds, but the programs that run there.
set(CMAKE_FIND_ROOT_PATH ${PALMER_STAGE} /usr/${prefix})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_LIBDIR} ${PALMER_STAGE}/lib/pkgconfig)
set(ENV{PKG_CONFIG_PATH} "")
set(ZLIB_LIBRARY /usr/${prefix}/lib/libz.a CACHE FILEPATH "")
set(ZLIB_INCLUDE_DIR /usr/${prefix}/include CACHE PATH "")
set(BUILD_SHARED_LIBS OFF CACHE BOOL "")

# Qt's tools run on the machine that builds.
set(QT_HOST_PATH /usr CACHE PATH "")
set(QT_HOST_PATH_CMAKE_DIR /usr/lib/x86_64-linux-gnu/cmake CACHE PATH "")
