# SPDX-License-Identifier: GPL-3.0-or-later
"""The libraries alone: Spack had no toml++, which the program needs. Written without having been built; packaging/README.md says what was checked."""

from spack.package import *


class Granum(CMakePackage):
    """Stiffness of granular packings: closed forms, contact networks and a compact DEM verifier."""

    homepage = "https://OWNER/granum"  # for the owner
    url = "https://OWNER/granum-0.2.0.tar.gz"

    license("GPL-3.0-or-later")

    version("0.2.0", sha256="HASH")

    variant("shared", default=False, description="Build shared libraries")

    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("boost@1.74:", type="build")
    depends_on("fast-float", type="build")
    depends_on("eigen@3.4:")
    depends_on("gsl")
    depends_on("zlib-api")
    depends_on("expat")

    def cmake_args(self):
        return [
            self.define_from_variant("BUILD_SHARED_LIBS", "shared"),
            self.define("GRANUM_BUILD_CLI", False),
            self.define("GRANUM_BUILD_TESTS", False),
            self.define("GRANUM_BUILD_EXAMPLES", False),
            self.define("GRANUM_BUILD_DOCS", False),
        ]
