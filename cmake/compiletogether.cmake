# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later

# compile_together(target "folder folder…" …): the sources of the folders named together are one for the compiler, which
# reads their headers and makes their copying and comparing once: a third of the time. So names in the unnamed namespaces
# of a folder differ, as what is meant the same stands in one place. "." are the sources of the target's own folder; those
# of a folder that is not named are compiled one by one. A source may be named instead of its folder.
function(compile_together target)
    if(PALMER_SINGLE_SOURCES) # ./lint looks at each alone
        return()
    endif()
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
        if(NOT source MATCHES "\\.cpp$")
            continue()
        endif()
        cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE file)
        cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
        cmake_path(GET file PARENT_PATH folder)
        if(folder STREQUAL "")
            set(folder .)
        endif()
        set(place "")
        foreach(folders IN LISTS ARGN)
            string(FIND " ${folders} " " ${folder} " withFolder)
            string(FIND " ${folders} " " ${file} " alone)
            if(withFolder GREATER -1 OR alone GREATER -1)
                string(MAKE_C_IDENTIFIER "${folders}" place)
            endif()
        endforeach()
        if(place STREQUAL "")
            set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
        else()
            set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${place})
        endif()
    endforeach()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# compile_quickly(target): what waits for people, disks and databases is optimized a little, which takes a quarter less
# time. A target of its own, since precompiled headers bring their optimization with them.
function(compile_quickly target)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()
