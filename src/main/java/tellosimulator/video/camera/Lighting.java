package tellosimulator.video.camera;

import java.util.Arrays;
import tellosimulator.math.Attitude;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.Lamps;
import tellosimulator.scenery.Lamps.Lamp;
import tellosimulator.scenery.Rgb;

/**
 * How bright a part's surfaces are in the light of the room's lamps. The lamps are taken to be
 * white, which they nearly are: then light acts the same in any colour space. Filled anew for each
 * part; for one thread.
 */
final class Lighting {

  private float[] lights = new float[0];

  /** The brightness of each normal, 0 to 1. */
  float[] lights() {
    return lights;
  }

  /** From now on the lights are those on a part in some attitude. */
  void shine(Lamps lamps, Shape shape, Attitude attitude) {
    float[] normals = shape.normals;
    int count = normals.length / 3;
    if (lights.length < count) {
      lights = new float[count];
    }
    Arrays.fill(lights, 0, count, (float) brightness(lamps.ambient()));
    for (Lamp lamp : lamps.all()) {
      Vec3 towards = attitude.toBody(lamp.direction()).times(-brightness(lamp.color()));
      add(normals, count, towards);
    }
  }

  private void add(float[] normals, int count, Vec3 towards) {
    float x = (float) towards.x();
    float y = (float) towards.y();
    float z = (float) towards.z();
    for (int i = 0; i < count; i++) {
      float light = x * normals[3 * i] + y * normals[3 * i + 1] + z * normals[3 * i + 2];
      lights[i] = Math.min(1, lights[i] + Math.max(0, light));
    }
  }

  /** ITU-R BT.601. */
  private static double brightness(Rgb color) {
    return (0.299 * color.red() + 0.587 * color.green() + 0.114 * color.blue()) / 255;
  }
}
