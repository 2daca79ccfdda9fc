"""The Conan 2 recipe of LocalGridSeg. It takes the source from the folder that it lies in: packaging/conan/../.."""
import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy

COMPONENTS = ["c", "brush", "debug", "pieces", "views", "falling", "tiled", "box2d"]  # each is an option here, and a component in CMake


class LocalGridSeg(ConanFile):
    name = "localgridseg"
    version = "0.3.0"
    license = "MIT"
    description = "Boundary segments and ghost vertices of an editable grid of polygons, at the cost of the edit"
    topics = ("game-development", "geometry", "box2d", "tiled")
    package_type = "library"
    settings = "os", "compiler", "build_type", "arch"
    options = {"shared": [True, False], "fPIC": [True, False]} | {name: [True, False] for name in COMPONENTS}
    default_options = {"shared": False, "fPIC": True} | {name: False for name in COMPONENTS}
    implements = ["auto_shared_fpic"]

    def export_sources(self):
        root = os.path.join(self.recipe_folder, "..", "..")
        for pattern in ["CMakeLists.txt", "LICENSE", "LICENSES.md", "cmake/*", "lib/*", "addons/*"]:
            copy(self, pattern, root, self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def validate(self):
        check_min_cppstd(self, 20)

    def requirements(self):
        self.requires("tl-expected/1.1.0", transitive_headers=True)
        if self.options.tiled:
            self.requires("fast_float/6.1.0", visible=False)
            self.requires("nlohmann_json/3.11.3", visible=False)
            self.requires("pcre2/10.42")
            self.requires("pugixml/1.14")
            self.requires("zlib/[>=1.2.11 <2]")
            self.requires("zstd/[>=1.5 <1.6]")
        if self.options.box2d:
            self.requires("box2d/2.4.1", transitive_headers=True)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["LGS_BUILD_TOOLS"] = False
        toolchain.cache_variables["LGS_BUILD_TESTS"] = False
        for name in COMPONENTS:
            toolchain.cache_variables[f"LGS_BUILD_{name.upper()}"] = bool(self.options.get_safe(name))
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        for name in ["LICENSE", "LICENSES.md"]:
            copy(self, name, self.source_folder, os.path.join(self.package_folder, "licenses"))
        CMake(self).install()

    def package_info(self):
        # The package's own CMake files have the targets and their components.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = [os.path.join("lib", "cmake", "LocalGridSeg")]
        prefix = "localgridseg_"
        libs = [prefix + name for name in ["box2d", "tiled", "falling", "debug"] if self.options.get_safe(name)]
        for name in ["pieces", "views"]:
            if self.options.get_safe(name) or self.options.falling:
                libs.append(prefix + name)
        if self.options.brush or self.options.tiled or self.options.falling:
            libs.append(prefix + "brush")
        self.cpp_info.libs = libs + ["localgridseg"]
