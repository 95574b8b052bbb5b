# A recipe for Conan 2. Checked for syntax only: see docs/packaging.md.
from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeToolchain, CMakeDeps, cmake_layout
from conan.tools.files import rmdir
import os


class Jauscat(ConanFile):
    name = "jauscat"
    version = "0.1.0"
    license = "BSL-1.0"
    description = "JAUS and EtherCAT messages as compile-time schemas, and a translator between them"
    topics = ("jaus", "ethercat", "robotics", "header-only")
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"net": [True, False]}
    default_options = {"net": True, "boost/*:header_only": True}
    exports_sources = "CMakeLists.txt", "LICENSE", "cmake/*", "include/*", "schemas/*", "src/*"
    no_copy_source = True

    def requirements(self):
        self.requires("boost/[>=1.74.0]", transitive_headers=True)
        if self.options.net:
            self.requires("pugixml/[>=1.10]", transitive_headers=True, transitive_libs=True)

    def validate(self):
        check_min_cppstd(self, 20)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["JAUSCAT_BUILD_TESTS"] = False
        toolchain.cache_variables["JAUSCAT_BUILD_EXAMPLES"] = False
        toolchain.cache_variables["JAUSCAT_BUILD_TOOLS"] = False
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        CMake(self).configure()

    def package(self):
        CMake(self).install(component="development")
        # Conan's generators write these for its users.
        rmdir(self, os.path.join(self.package_folder, "share", "cmake"))
        rmdir(self, os.path.join(self.package_folder, "share", "pkgconfig"))

    def package_id(self):
        self.info.clear()

    def package_info(self):
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
        self.cpp_info.set_property("cmake_file_name", "jauscat")
        codec = self.cpp_info.components["codec"]
        codec.set_property("cmake_target_name", "jauscat::jauscat")
        codec.set_property("pkg_config_name", "jauscat")
        codec.requires = ["boost::headers"]
        text = self.cpp_info.components["text"]
        text.set_property("cmake_target_name", "jauscat::text")
        text.requires = ["codec"]
        if self.options.net:
            esi = self.cpp_info.components["esi"]
            esi.set_property("cmake_target_name", "jauscat::esi")
            esi.set_property("pkg_config_name", "jauscat-esi")
            esi.requires = ["codec", "pugixml::pugixml"]
            net = self.cpp_info.components["net"]
            net.set_property("cmake_target_name", "jauscat::net")
            net.set_property("pkg_config_name", "jauscat-net")
            net.requires = ["codec", "pugixml::pugixml"]
            if self.settings.os == "Linux":
                net.system_libs = ["pthread"]
