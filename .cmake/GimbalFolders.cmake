# SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# One small library per folder, named after it (protocol/base -> protocol_base).

add_library(gimbal_options INTERFACE)
target_include_directories(gimbal_options INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(gimbal_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
    -Woverloaded-virtual -Wnull-dereference $<$<BOOL:${GIMBAL_WERROR}>:-Werror>
    # Qt 6.4's inline containers trip these in optimised GCC 12 builds; they are its own code, not ours.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-null-dereference -Wno-array-bounds -Wno-stringop-overflow -Wno-restrict>)
target_compile_definitions(gimbal_options INTERFACE QT_NO_CAST_FROM_ASCII QT_NO_CAST_TO_ASCII
    QT_NO_FOREACH QT_NO_JAVA_STYLE_ITERATORS GIMBAL_VERSION="${PROJECT_VERSION}")
find_program(GIMBAL_MOLD mold)
if(GIMBAL_MOLD)
    target_link_options(gimbal_options INTERFACE -fuse-ld=mold)
endif()
find_program(GIMBAL_CCACHE ccache)
if(GIMBAL_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${GIMBAL_CCACHE})
endif()

# gimbal_folder(path deps...): a dep with a slash and no '::' is another folder of this repository.
function(gimbal_folder path)
    string(REPLACE "/" "_" name ${path})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${path}/*.cpp ${CMAKE_SOURCE_DIR}/${path}/*.h)
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PUBLIC gimbal_options Threads::Threads)
    foreach(dep ${ARGN})
        if(dep MATCHES "::")
            target_link_libraries(${name} PUBLIC ${dep})
        else()
            string(REPLACE "/" "_" dep ${dep})
            target_link_libraries(${name} PUBLIC ${dep})
        endif()
    endforeach()
endfunction()

function(gimbal_program name source)
    add_executable(${name} ${CMAKE_SOURCE_DIR}/${source})
    foreach(dep ${ARGN})
        string(REPLACE "/" "_" dep ${dep})
        target_link_libraries(${name} PRIVATE ${dep})
    endforeach()
endfunction()

file(GLOB_RECURSE GIMBAL_RESOURCE_FILES CONFIGURE_DEPENDS
    ${CMAKE_SOURCE_DIR}/resources/icons/*.svg ${CMAKE_SOURCE_DIR}/resources/help/*.md)
