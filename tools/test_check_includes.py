#!/usr/bin/env python3
"""Tests check_includes.py on small trees made for the purpose."""

import os
import tempfile
import unittest

import check_includes


class CheckIncludes(unittest.TestCase):
    def complaints(self, files):
        with tempfile.TemporaryDirectory() as root:
            for path, text in files.items():
                target = os.path.join(root, path)
                os.makedirs(os.path.dirname(target), exist_ok=True)
                with open(target, "w", encoding="utf-8") as file:
                    file.write(text)
            return check_includes.check(root)

    def assert_clean(self, files):
        self.assertEqual(self.complaints(files), [])

    def assert_refused(self, files, *words):
        complaints = self.complaints(files)
        self.assertEqual(len(complaints), 1, complaints)
        for word in words:
            self.assertIn(word, complaints[0])

    def test_a_folder_sees_itself_what_the_table_grants_and_public_headers(self):
        self.assert_clean({
            "include/velarium/error.hpp": "#include <string>\n",
            "src/core/files.hpp": "#include <velarium/error.hpp>\n",
            "src/image/png.hpp": "",
            "src/image/png.cpp": '#include "image/png.hpp"\n#include "png.hpp"\n#include "core/files.hpp"\n#include <png.h>\n',
        })

    def test_data_has_one_direction(self):
        self.assert_refused({"src/core/log.hpp": '#include "image/png.hpp"\n', "src/image/png.hpp": ""},
                            "src/core/log.hpp:1", "image/png.hpp")

    def test_the_complaint_names_the_line(self):
        self.assert_refused({"src/gpu/a.cpp": '// one\n\n  #  include "scene/scene.hpp"\n', "src/scene/scene.hpp": ""},
                            "src/gpu/a.cpp:3")

    def test_of_another_technique_a_pass_sees_what_is_made_to_be_read(self):
        files = {f"src/passes/probes/{name}": "" for name in ("probes.hpp", "read.hpp", "read.glsl", "probes_io.glsl")}
        for name in ("read.hpp", "read.glsl", "probes_io.glsl"):
            include = f'#include "passes/probes/{name}"\n'
            self.assert_clean(files | {"src/passes/lighting/lighting.cpp": include})
            self.assert_clean(files | {"src/passes/illumination.glsl": include})
            self.assert_refused(files | {"src/passes/ssdo/ssdo.cpp": include}, "illumination")
            self.assert_refused(files | {"src/passes/fullscreen.hpp": include}, "illumination")
        include = '#include "passes/probes/probes.hpp"\n'
        for path in ("src/passes/lighting/lighting.cpp", "src/passes/illumination.cpp", "src/passes/ssdo/ssdo.cpp"):
            self.assert_refused(files | {path: include}, "read*")

    def test_every_pass_reads_the_gbuffer(self):
        files = {"src/passes/gbuffer/read_depth_buffer.glsl": "", "src/passes/gbuffer/gbuffer.hpp": ""}
        self.assert_clean(files | {"src/passes/ssdo/ssdo.comp.glsl": '#include "passes/gbuffer/read_depth_buffer.glsl"\n'})
        self.assert_refused(files | {"src/passes/ssdo/ssdo.cpp": '#include "passes/gbuffer/gbuffer.hpp"\n'}, "read*")

    def test_gpu_sees_the_language_of_shading_and_none_of_its_maths(self):
        files = {"src/shading/lang.glsl": "", "src/shading/brdf.glsl": ""}
        self.assert_clean(files | {"src/gpu/samplers.glsl": '#include "shading/lang.glsl"\n'})
        self.assert_refused(files | {"src/gpu/samplers.glsl": '#include "shading/brdf.glsl"\n'}, "lang.glsl")

    def test_passes_share_what_stands_beside_their_folders(self):
        self.assert_clean({"src/passes/ssdo/ssdo.cpp": '#include "passes/fullscreen.hpp"\n#include "passes/ssdo/ssdo.hpp"\n',
                           "src/passes/fullscreen.hpp": "", "src/passes/ssdo/ssdo.hpp": ""})

    def test_shaders_obey_too(self):
        self.assert_refused({"src/shading/brdf.glsl": '#include "passes/taa/taa.glsl"\n', "src/passes/taa/taa.glsl": ""},
                            "src/shading/brdf.glsl:1")

    def test_a_relative_path_does_not_hide_a_folder(self):
        self.assert_refused({"src/reference/trace.cpp": '#include "../gpu/device.hpp"\n', "src/gpu/device.hpp": ""},
                            "reference may see")

    def test_vulkan_stays_behind_gpu(self):
        for header in ("vulkan/vulkan.h", "volk.h"):
            self.assert_refused({"src/scene/scene.cpp": f"#include <{header}>\n"}, "src/scene/scene.cpp:1")
            self.assert_clean({"src/passes/taa/taa.cpp": f"#include <{header}>\n"})

    def test_the_command_line_sees_public_headers_only(self):
        files = {"apps/velarium/render.hpp": "", "src/core/files.hpp": "", "include/velarium/engine.hpp": ""}
        self.assert_clean(files | {"apps/velarium/render.cpp": '#include "render.hpp"\n#include <velarium/engine.hpp>\n'})
        self.assert_refused(files | {"apps/velarium/render.cpp": '#include "core/files.hpp"\n'}, "public headers only")

    def test_public_headers_need_nothing_else(self):
        self.assert_refused({"include/velarium/scene.hpp": "#include <glm/vec3.hpp>\n"}, "glm/")
        self.assert_refused({"include/velarium/scene.hpp": "#include <unistd.h>\n"}, "standard library")
        self.assert_refused({"include/velarium/scene.hpp": '#include "scene/scene.hpp"\n', "src/scene/scene.hpp": ""},
                            "public")

    def test_built_in_scenes_belong_to_the_scene_folder(self):
        self.assert_clean({"scenes/spheres.cpp": '#include "scene/scene.hpp"\n', "src/scene/scene.hpp": ""})
        self.assert_refused({"scenes/spheres.cpp": '#include "gpu/device.hpp"\n', "src/gpu/device.hpp": ""}, "scene may see")

    def test_a_new_folder_needs_a_row(self):
        self.assert_refused({"src/audio/mix.cpp": ""}, "not in the table")


if __name__ == "__main__":
    unittest.main()
