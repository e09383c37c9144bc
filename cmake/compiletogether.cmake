# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Compiles the sources of a target some at a time, which takes half the time; so names in their unnamed namespaces have
# to differ. Which go together is drawn from their names: a new source joins one of the groups and moves no other. The
# lot is one without clashes.
function(compile_together target lot groups)
    if(CMAKE_DISABLE_PRECOMPILE_HEADERS) # ./lint looks at each source alone
        return()
    endif()
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
        if(source MATCHES "\\.cpp$")
            cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE file)
            cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
            string(MD5 digest "${lot}${file}")
            string(SUBSTRING ${digest} 0 4 drawn)
            math(EXPR group "0x${drawn} % ${groups}")
            set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
        endif()
    endforeach()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
