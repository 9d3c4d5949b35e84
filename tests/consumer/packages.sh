#!/bin/sh
# kernel/ as a package, from a copy of that folder alone: packages.sh PROJECT
# The package systems themselves are not run. Every manifest parses, has what its system requires, and names files that
# exist. It states the version of kernel/CMakeLists.txt and the licence. ESP-IDF's branch of CMakeLists.txt runs as
# CMake, with a stand-in for idf_component_register. The Arduino layout compiles.
. "$(dirname "$0")/../folder.sh"
project=$1
needs python3
cp -r "$project/kernel" "$folder/kernel"
cd "$folder"

python3 - <<'END'
import json, os, re

version = re.search(r"project\(impact_kernel VERSION (\S+)", open("kernel/CMakeLists.txt").read()).group(1)

def flat_yaml(path):  # the two manifests use maps of scalars only
    entries, parents = {}, []
    for line in open(path):
        if line.startswith("#"):
            continue
        indent, key, value = re.fullmatch(r'( *)([\w-]+): ?"?(.*?)"?\n', line).groups()
        parents = parents[: len(indent) // 2] + [key]
        entries[".".join(parents)] = value
    return entries

pio = json.load(open("kernel/library.json"))
assert re.fullmatch(r"[A-Za-z0-9_-]{1,50}", pio["name"]), pio["name"]
assert pio["version"] == version and len(pio["description"]) <= 255
for header in pio["headers"]:
    assert os.path.isfile(os.path.join("kernel", pio["build"]["includeDir"], header)), header

idf = flat_yaml("kernel/idf_component.yml")
assert idf["version"] == version and idf["description"] and idf["dependencies.idf"].startswith(">=")

zephyr = flat_yaml("kernel/zephyr/module.yml")
assert zephyr["name"] == "impact"
assert os.path.isfile(os.path.join("kernel", zephyr["build.cmake"], "CMakeLists.txt"))

arduino = dict(line.rstrip("\n").split("=", 1) for line in open("kernel/library.properties") if line[0] != "#")
required = {"name", "version", "author", "maintainer", "sentence", "paragraph", "category", "url", "architectures"}
assert required <= arduino.keys(), required - arduino.keys()
assert arduino["version"] == version
assert all(arduino[key] for key in required) and re.fullmatch(r"https?://\S+", arduino["url"]), "an empty value"
assert set(arduino["architectures"].split(",")) <= {"rp2040", "esp32", "stm32"}, "an architecture that brings GCC 7, or is AVR's"
assert open("kernel/CHANGELOG.md").read().split("## ")[1].split()[0] == version, "CHANGELOG.md begins with another version"

# Each package contains the licence.
assert pio["license"] == idf["license"] == "MIT" and "MIT" in arduino["paragraph"]
assert open("kernel/LICENSE").read().startswith("MIT License")
for folder, _, names in os.walk("kernel"):
    for name in names:
        path = os.path.join(folder, name)
        if name == "LICENSE" or name.endswith((".json", ".md")):
            continue
        assert "SPDX-License-Identifier: MIT" in open(path).readline(), path + " states no licence"
assert os.path.isfile(os.path.join("kernel/include", arduino["includes"]))
END

mkdir esp_idf
cat >esp_idf/CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.20)
project(esp_idf LANGUAGES CXX)
macro(idf_component_register)  # a component without sources is an interface library
  cmake_parse_arguments(component "" "" "INCLUDE_DIRS" ${ARGN})
  set(COMPONENT_LIB impact_component)
  add_library(${COMPONENT_LIB} INTERFACE)
  target_include_directories(${COMPONENT_LIB} INTERFACE ${component_INCLUDE_DIRS})
endmacro()
add_subdirectory(../kernel impact)
file(WRITE main.cpp "#include <impact/absorber.hpp>\n#include <impact.h>\n")
add_library(main STATIC main.cpp)
target_link_libraries(main PRIVATE impact_component)
END
cmake -S esp_idf -B esp_idf/build -DESP_PLATFORM=1 >log || { cat log && exit 1; }
cmake --build esp_idf/build >log || { cat log && exit 1; }

# In an Arduino library the folder include/ is called src/, and only src/ is searched.
mv kernel/include kernel/src
echo '#include <impact.h>' | c++ -std=gnu++17 -fsyntax-only -I kernel/src -x c++ -
