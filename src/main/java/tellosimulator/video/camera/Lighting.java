package tellosimulator.video.camera;

import java.util.Arrays;
import tellosimulator.math.Attitude;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Lights;
import tellosimulator.scenery.mesh.Lights.Directional;
import tellosimulator.scenery.mesh.Rgb;

/**
 * Computes the diffuse (Lambert) lighting of a mesh at each of its normals. The lights are treated
 * as white, which is nearly correct, so that light has the same effect in any colour space. Reused
 * for each mesh. Not thread-safe.
 */
final class Lighting {

  private float[] intensities = new float[0];

  /** The light at each normal, 0 to 1. */
  float[] intensities() {
    return intensities;
  }

  /** Computes the light on a mesh that has the given attitude. */
  void illuminate(Lights lights, RenderMesh mesh, Attitude attitude) {
    float[] normals = mesh.normals;
    int count = normals.length / 3;
    if (intensities.length < count) {
      intensities = new float[count];
    }
    Arrays.fill(intensities, 0, count, (float) luma(lights.ambient()));
    for (Directional light : lights.directional()) {
      Vec3 towards = attitude.toBody(light.direction()).times(-luma(light.color()));
      addDiffuse(normals, count, towards);
    }
  }

  private void addDiffuse(float[] normals, int count, Vec3 towards) {
    float x = (float) towards.x();
    float y = (float) towards.y();
    float z = (float) towards.z();
    for (int i = 0; i < count; i++) {
      float light = x * normals[3 * i] + y * normals[3 * i + 1] + z * normals[3 * i + 2];
      intensities[i] = Math.min(1, intensities[i] + Math.max(0, light));
    }
  }

  /** Returns the luma of a colour according to ITU-R BT.601. */
  private static double luma(Rgb color) {
    return (0.299 * color.red() + 0.587 * color.green() + 0.114 * color.blue()) / 255;
  }
}
