"""Draws one picture inside Blender: blender -b --python blender_peer.py -- SCENE ENV OUT ENGINE SAMPLES W H EYE TARGET FOV"""

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


def main():
    scene, env, out, engine, samples, width, height, *camera = sys.argv[sys.argv.index("--") + 1:]
    numbers = [float(text) for text in camera]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=scene)
    add_camera(numbers[0:3], numbers[3:6], numbers[6])
    add_environment(env)
    settings = bpy.context.scene
    settings.render.engine = engine
    settings.render.resolution_x, settings.render.resolution_y = int(width), int(height)
    settings.render.filepath = out
    settings.eevee.taa_render_samples = int(samples)
    settings.eevee.use_gtao = settings.eevee.use_ssr = True
    settings.cycles.samples, settings.cycles.use_denoising = int(samples), False
    bpy.ops.render.render(write_still=True)


main()
