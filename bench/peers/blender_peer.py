"""Draws one picture inside Blender: blender -b --python blender_peer.py -- JOB, a JSON object; `common.py` writes it."""

import json
import math
import sys

import numpy

# Blender 3.4's glTF reader uses names that numpy 1.24 has dropped.
for alias in (bool, float, int, object):
    setattr(numpy, alias.__name__, alias)

import bpy
import mathutils


def from_gltf(point):
    """glTF has +Y up, Blender +Z."""
    x, y, z = point
    return mathutils.Vector((x, -z, y))


def add_camera(eye, target, fov_deg):
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    data.angle = math.radians(fov_deg)
    data.clip_start = 0.05
    camera = bpy.data.objects.new("camera", data)
    camera.location = from_gltf(eye)
    camera.rotation_euler = (from_gltf(target) - from_gltf(eye)).to_track_quat("-Z", "Y").to_euler()
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.scene.camera = camera


def add_environment(file):
    world = bpy.data.worlds.new("environment")
    world.use_nodes = True
    texture = world.node_tree.nodes.new("ShaderNodeTexEnvironment")
    texture.image = bpy.data.images.load(file)
    world.node_tree.links.new(texture.outputs["Color"], world.node_tree.nodes["Background"].inputs["Color"])
    bpy.context.scene.world = world


def trace_as_velarium_does(settings, job):
    """Makes Cycles estimate the integral that `velarium reference` estimates, by the same number of paths.

    What would cut light off, blur it, or stop early is off; pixels are boxes. Paths end by roulette alone, which Cycles
    plays from the first reflection on and we from the fourth: each is left to its own way.
    """
    cycles = settings.cycles
    cycles.samples, cycles.seed = job["samples"], job["seed"]
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    # Both count reflections after the first: 0 is direct light.
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = job["bounces"]
    cycles.transparent_max_bounces = 256
    cycles.min_light_bounces = cycles.min_transparent_bounces = 0
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
    cycles.light_sampling_threshold = 0.0
    cycles.blur_glossy = 0.0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.pixel_filter_type = "BOX"
    settings.render.threads_mode, settings.render.threads = "FIXED", job["threads"]


def write_linear_light(settings):
    """An .exr file holds the light itself: neither a view transform nor exposure touches it."""
    settings.render.image_settings.file_format = "OPEN_EXR"
    settings.render.image_settings.color_mode = "RGB"
    settings.render.image_settings.color_depth = "32"


def main():
    job = json.loads(sys.argv[-1])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=job["scene"])
    add_camera(job["eye"], job["target"], job["fov"])
    add_environment(job["env"])
    settings = bpy.context.scene
    settings.render.engine = job["engine"]
    settings.render.resolution_x, settings.render.resolution_y = job["size"]
    settings.render.filepath = job["out"]
    if job["out"].endswith(".exr"):
        write_linear_light(settings)
    settings.eevee.taa_render_samples = job["samples"]
    settings.eevee.use_gtao = settings.eevee.use_ssr = True
    trace_as_velarium_does(settings, job)
    bpy.ops.render.render(write_still=True)


main()
