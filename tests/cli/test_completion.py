"""Shell completion and the manual page: what they offer is what the program takes."""

import os
import pathlib
import re
import shutil
import subprocess
import unittest

from harness import BINARY, CliTest, OK, USAGE, main


class Candidates(CliTest):
    def candidates(self, *words):
        out = self.expect(OK, "completion", "words", "--", *words)
        return [line.split("\t")[0] for line in out.splitlines()]

    def test_verbs_scenes_and_files_come_first(self):
        found = self.candidates("")
        for word in ("render", "completion", "builtin:spheres", ":files"):
            self.assertIn(word, found)

    def test_flags_are_those_of_the_help(self):
        for verb in ("render", "info", "devices", "bench", "options"):
            told = set(re.findall(r"(?<![\w-])--[a-z][a-z0-9-]+", self.expect(OK, verb, "--help")))
            offered = set(self.candidates(verb, "--"))
            self.assertTrue(offered and offered <= told, f"{verb}: {offered - told}")

    def test_values_follow_their_flag(self):
        self.assertEqual(self.candidates("render", "--tonemap", "a"), ["agx", "aces"])
        self.assertEqual(self.candidates("render", "--env=st"), ["--env=studio", ":files"])
        self.assertEqual(self.candidates("render", "-o", "x"), [":files"])
        self.assertEqual(self.candidates("render", "--size", ""), [])

    def test_options_of_the_table_and_their_values(self):
        self.assertEqual(self.candidates("render", "-D", "display.ton"), ["display.tonemap="])
        self.assertEqual(self.candidates("render", "-D", "lighting.path="),
                         ["lighting.path=tiled", "lighting.path=volumes", "lighting.path=all"])
        self.assertEqual(self.candidates("bench", "-D", "lighting.occlusion=o"),
                         ["lighting.occlusion=on", "lighting.occlusion=off"])

    def test_a_scene_without_a_verb_is_drawn(self):
        self.assertEqual(self.candidates("a.gltf", "--spp"), ["--spp"])


class Scripts(CliTest):
    def test_shells_accept_their_script(self):
        for shell in ("bash", "zsh", "fish"):
            script = self.write(f"script.{shell}", self.expect(OK, "completion", shell))
            if shutil.which(shell):
                subprocess.run([shell, "-n", script], check=True)

    def test_other_shells_are_refused(self):
        self.expect(USAGE, "completion", "tcsh", says="bash, zsh and fish")

    @unittest.skipUnless(shutil.which("bash"), "no bash")
    def test_bash_replaces_only_the_part_after_a_sign(self):
        # Outside a completion under way compopt is an error; what it sets does not matter here.
        program = """
            compopt() { :; }
            source <(velarium completion bash)
            COMP_LINE="velarium $1" COMP_POINT=$((9 + ${#1}))
            _velarium; echo "${COMPREPLY[*]}" """
        path = os.pathsep.join((str(pathlib.Path(BINARY).parent), os.environ["PATH"]))
        for line, expected in (("render -D display.tonemap=ag", "agx"), ("builtin:sph", "spheres"),
                               ("render --tonem", "--tonemap")):
            done = subprocess.run(["bash", "-c", program, "bash", line], cwd=self.folder, capture_output=True, text=True,
                                  check=True, env={**os.environ, "PATH": path})
            self.assertEqual(done.stdout.strip(), expected, done.stderr)


class ManPage(CliTest):
    def test_it_names_every_verb_flag_and_option(self):
        page = self.expect(OK, "options", "--man").replace("\\-", "-")
        for word in ("velarium render", "velarium completion", "--tonemap", "display.tonemap", "neutral", "EXIT STATUS"):
            self.assertIn(word, page)

    @unittest.skipUnless(shutil.which("groff"), "no groff")
    def test_roff_has_no_objection(self):
        page = self.write("velarium.1", self.expect(OK, "options", "--man"))
        done = subprocess.run(["groff", "-man", "-ww", "-z", "-Tutf8", page], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    main()
