"""--variant: which materials a file with KHR_materials_variants shows."""

import json
import pathlib

from harness import OK, SMALL, USAGE, CliTest, main, needs_device, read_png

BENCH = str(pathlib.Path(__file__).resolve().parent.parent / "data" / "variants.gltf")


class Choice(CliTest):
    def test_info_lists_them(self):
        self.assertEqual(json.loads(self.expect(OK, "info", BENCH, "--json"))["variants"], ["beech", "walnut", "steel"])

    def test_one_that_is_not_there_is_answered_with_those_that_are(self):
        for unknown in ("pine", "3", "Walnut"):
            self.expect(USAGE, "render", BENCH, "--variant", unknown, *SMALL, "-o", "a.png",
                        says='there are: 0 "beech", 1 "walnut", 2 "steel", none')
        self.assertEqual(self.names(), [])

    def test_a_scene_without_any_says_so(self):
        plain = str(pathlib.Path(BENCH).with_name("triangle.gltf"))
        self.expect(USAGE, "render", plain, "--variant", "walnut", *SMALL, "-o", "a.png", says="there are: none")


@needs_device
class Pictures(CliTest):
    def draw(self, *arguments):
        return read_png(self.render(BENCH, *arguments))

    def test_a_name_and_its_index_are_one_choice(self):
        self.assertEqual(self.draw("--variant", "walnut"), self.draw("--variant", "1"))

    def test_each_looks_different(self):
        usual = self.draw()
        self.assertEqual(usual, self.draw("--variant", "none"))
        pictures = [usual] + [self.draw("--variant", name) for name in ("beech", "walnut", "steel")]
        for i, picture in enumerate(pictures):
            self.assertNotIn(picture, pictures[:i])


if __name__ == "__main__":
    main()
