# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Run by moc_headers: MOC is the program, FOLDER holds headers.txt and gets mocs.cpp, written anew when it changes.
cmake_policy(VERSION 3.25)
file(READ ${FOLDER}/headers.txt headers)
set(all)
foreach(header IN LISTS headers)
    file(STRINGS ${header} object REGEX "^ +Q_(OBJECT|GADGET)" LIMIT_COUNT 1)
    if(object)
        execute_process(COMMAND ${MOC} ${header} OUTPUT_VARIABLE made COMMAND_ERROR_IS_FATAL ANY)
        string(APPEND all "${made}")
    endif()
endforeach()
file(CONFIGURE OUTPUT ${FOLDER}/mocs.cpp CONTENT "@all@" @ONLY)
