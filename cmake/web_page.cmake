# SPDX-License-Identifier: Apache-2.0

# tegotae_embed_web_page(TARGET): builds the page of the live view from viewer/ with esbuild, and puts it into the
# target as bytes, which tegotae/stream/web_page.cpp hands out.
function(tegotae_embed_web_page target)
  set(packages three uplot esbuild)
  find_program(TEGOTAE_NODE NAMES node nodejs)
  set(package_files)
  foreach(package IN LISTS packages)
    set(file "${PROJECT_SOURCE_DIR}/node_modules/${package}/package.json")
    if(NOT TEGOTAE_NODE OR NOT EXISTS "${file}")
      message(FATAL_ERROR "The page of the live view needs Node.js and the npm packages three, uplot and esbuild; "
        "tools/install_dependencies installs them.")
    endif()
    list(APPEND package_files "${file}")
  endforeach()

  set(folder "${PROJECT_BINARY_DIR}/viewer")
  set(page "${folder}/index.html" "${folder}/app.js" "${folder}/app.css" "${folder}/licenses.txt")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/viewer/*")
  add_custom_command(OUTPUT ${page}
    COMMAND "${TEGOTAE_NODE}" "${PROJECT_SOURCE_DIR}/viewer/build.mjs" "${folder}"
    DEPENDS ${sources} ${package_files} COMMENT "Bundling the page" VERBATIM)

  set(stub "${folder}/web_page.S")
  set(TEGOTAE_PAGE_FOLDER "${folder}")
  configure_file("${PROJECT_SOURCE_DIR}/cmake/web_page.S.in" "${stub}" @ONLY)
  set_source_files_properties("${stub}" PROPERTIES OBJECT_DEPENDS "${page}")
  target_sources(${target} PRIVATE "${stub}")
endfunction()
