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

# Precompiled headers, one per floor and not one per folder: making one takes as long as compiling a page. Targets that reuse one
# have to be compiled with the same options.
function(gimbal_precompile name header)
    add_library(${name} OBJECT ${CMAKE_SOURCE_DIR}/.cmake/pch/empty.cpp)
    target_link_libraries(${name} PUBLIC gimbal_options Threads::Threads ${ARGN})
    if(GIMBAL_PCH)
        target_precompile_headers(${name} PRIVATE ${CMAKE_SOURCE_DIR}/.cmake/pch/${header})
    endif()
endfunction()
function(gimbal_reuse name from)
    if(GIMBAL_PCH)
        target_precompile_headers(${name} REUSE_FROM ${from})
    endif()
endfunction()
gimbal_precompile(gimbal_pch_core core.h Qt6::Core tl::expected)
gimbal_precompile(gimbal_pch_screen screen.h Qt6::Widgets tl::expected)
gimbal_precompile(gimbal_pch_app app.h Qt6::Widgets Qt6::Network tl::expected)

# Sources of a folder are compiled together, some at a time: what their headers drag in is half of the work otherwise. So names that are
# local to a file have to be unique within its folder. Tools that read compile_commands.json want each file by itself.
option(GIMBAL_UNITY "Compile the sources of a folder together" ON)

# gimbal_moc(target source output options...): AUTOMOC would take a step and an object of its own for each folder. moc gets no include paths: it
# needs nothing from there, and reading what Qt's headers include takes ten times as long. gimbal_moc_target has to follow in the
# same directory: listed in a target without dependencies, moc waits for no library.
function(gimbal_moc target source output)
    get_filename_component(folder ${output} DIRECTORY)
    file(MAKE_DIRECTORY ${folder})
    add_custom_command(OUTPUT ${output} COMMAND Qt6::moc ${ARGN} ${source} -o ${output} DEPENDS ${source} VERBATIM)
    target_sources(${target} PRIVATE ${output})
    set_property(DIRECTORY APPEND PROPERTY GIMBAL_MOCS ${output})
endfunction()
function(gimbal_moc_target name)
    get_property(mocs DIRECTORY PROPERTY GIMBAL_MOCS)
    add_custom_target(${name} DEPENDS ${mocs})
endfunction()

# gimbal_meta_objects(target folder headers...): moc for those that need it. The others are looked at again when they change.
function(gimbal_meta_objects target folder)
    foreach(header ${ARGN})
        file(STRINGS ${header} found REGEX "^ *Q_(OBJECT|GADGET|NAMESPACE)" LIMIT_COUNT 1)
        if(found)
            get_filename_component(name ${header} NAME_WE)
            gimbal_moc(${target} ${header} ${CMAKE_BINARY_DIR}/${folder}/moc_${name}.cpp)
        else()
            set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
        endif()
    endforeach()
endfunction()

# gimbal_folder(path deps...): a dep with a slash and no '::' is another folder of this repository.
function(gimbal_folder path)
    string(REPLACE "/" "_" name ${path})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${path}/*.cpp)
    file(GLOB headers CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${path}/*.h)
    add_library(${name} STATIC ${sources} ${headers})
    target_link_libraries(${name} PUBLIC gimbal_options Threads::Threads)
    gimbal_meta_objects(${name} ${path} ${headers})
    set_target_properties(${name} PROPERTIES UNITY_BUILD ${GIMBAL_UNITY} UNITY_BUILD_BATCH_SIZE 12)
    if(path MATCHES "^(protocol/|widgets/models|widgets/gamepad|app/composition|app/cli)")
        gimbal_reuse(${name} gimbal_pch_core)
    elseif(path MATCHES "^app/(pages|families|mainwindow|tour)")
        gimbal_reuse(${name} gimbal_pch_app)
    else()
        gimbal_reuse(${name} gimbal_pch_screen)
    endif()
    foreach(dep ${ARGN})
        if(dep MATCHES "::")
            target_link_libraries(${name} PUBLIC ${dep})
        else()
            string(REPLACE "/" "_" dep ${dep})
            target_link_libraries(${name} PUBLIC ${dep})
        endif()
    endforeach()
endfunction()

# gimbal_module(name path libraries...): a library that a program loads when it is first needed, with whatever it needs that would cost
# at every start. It sees headers of its floors only, and links none of them. It lies beside the programs, and is installed in a
# folder of its own.
include(GNUInstallDirs)
file(RELATIVE_PATH GIMBAL_MODULES_FROM_PROGRAMS /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR}/gimbaldesk)
function(gimbal_module name path)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${path}/*.cpp)
    file(GLOB headers CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${path}/*.h)
    add_library(gimbaldesk-${name} MODULE ${sources} ${headers})
    target_link_libraries(gimbaldesk-${name} PRIVATE gimbal_options Qt6::Core tl::expected ${ARGN})
    foreach(header ${headers})
        file(STRINGS ${header} found REGEX "^ *Q_(OBJECT|PLUGIN)" LIMIT_COUNT 1)
        if(NOT found)
            continue()
        endif()
        get_filename_component(stem ${header} NAME_WE)  # our headers are read along: one of them declares the module's interface
        gimbal_moc(gimbaldesk-${name} ${header} ${CMAKE_BINARY_DIR}/${path}/moc_${stem}.cpp -I ${CMAKE_SOURCE_DIR})
    endforeach()
    set_target_properties(gimbaldesk-${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/modules)
    install(TARGETS gimbaldesk-${name} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/gimbaldesk)
endfunction()

function(gimbal_program name source)
    add_executable(${name} ${CMAKE_SOURCE_DIR}/${source})
    gimbal_reuse(${name} gimbal_pch_core)
    foreach(dep ${ARGN})
        string(REPLACE "/" "_" dep ${dep})
        target_link_libraries(${name} PRIVATE ${dep})
    endforeach()
endfunction()

file(GLOB_RECURSE GIMBAL_RESOURCE_FILES CONFIGURE_DEPENDS
    ${CMAKE_SOURCE_DIR}/resources/icons/*.svg ${CMAKE_SOURCE_DIR}/resources/help/*.md)
