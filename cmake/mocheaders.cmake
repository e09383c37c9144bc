# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later

# What moc makes of the headers of a target, as one source. AUTOMOC has moc read all of Qt before each header, which
# takes fifty times as long and gives the same.
set(mocheaders_script ${CMAKE_CURRENT_LIST_DIR}/runmoc.cmake)
function(moc_headers target)
    get_target_property(sources ${target} SOURCES)
    set(headers)
    foreach(source IN LISTS sources)
        if(source MATCHES "\\.h$")
            cmake_path(ABSOLUTE_PATH source NORMALIZE)
            cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
            list(APPEND headers ${source})
        endif()
    endforeach()
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/moc)
    file(CONFIGURE OUTPUT ${folder}/headers.txt CONTENT "@headers@" @ONLY)
    list(TRANSFORM headers PREPEND ${PROJECT_SOURCE_DIR}/)
    add_custom_command(OUTPUT ${folder}/mocs.cpp VERBATIM COMMENT "moc of ${target}"
        WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
        DEPENDS ${headers} ${folder}/headers.txt ${mocheaders_script}
        COMMAND ${CMAKE_COMMAND} -D MOC=$<TARGET_FILE:Qt6::moc> -D FOLDER=${folder} -P ${mocheaders_script})
    target_sources(${target} PRIVATE ${folder}/mocs.cpp)
endfunction()
