# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Static libraries do not say what they need themselves (packaging/windows/libraries builds them).
set(PALMER_STATIC ON)
find_package(Freetype REQUIRED)
find_package(JPEG REQUIRED)
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)
find_library(POPPLER_CORE_LIBRARY poppler REQUIRED)
set(POPPLER_LIBRARY ${POPPLER_LIBRARY} ${POPPLER_CORE_LIBRARY} Freetype::Freetype JPEG::JPEG PNG::PNG ZLIB::ZLIB)
set_target_properties(qpdf::libqpdf PROPERTIES INTERFACE_LINK_LIBRARIES "JPEG::JPEG;ZLIB::ZLIB") # it names a DLL
set(ZIP_LIBRARY ${ZIP_LIBRARY} ZLIB::ZLIB)
add_compile_definitions(ZIP_STATIC LIBXML_STATIC)
