# What the Python module needs: Debian's Python, not another one on the PATH, and pybind11.
find_program(Python_EXECUTABLE python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(Python_EXECUTABLE python3)
set(PYBIND11_FINDPYTHON ON)
find_package(Python 3.9 COMPONENTS Interpreter Development.Module QUIET)
find_package(pybind11 2.10 QUIET)
if(NOT TARGET pybind11::module)
    message(STATUS "The Python module is left out: it needs pybind11 (pybind11-dev, python3-dev)")
endif()
