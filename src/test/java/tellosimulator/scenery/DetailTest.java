package tellosimulator.scenery;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.math.Attitude;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.world.Decor;
import tellosimulator.world.Walls;

/** Checks that a drone's camera sees visual detail in every direction. */
class DetailTest {

  /** A coarse image with the camera's aspect ratio; finer detail does not count here. */
  private static final int WIDTH = 64;

  private static final int HEIGHT = 48;

  /** Rays per pixel along a row and along a column. */
  private static final int RAYS = 3;

  /** Focal length for an image of width 1: a field of view of 55 degrees. */
  private static final double FOCAL_LENGTH = 0.5 / Math.tan(Math.toRadians(55) / 2);

  private static final SimConfig TEXTURED =
      SimConfig.DEFAULT.withDecor(Decor.DEFAULT.withWalls(Walls.TEXTURED));

  private static final double TILT = Math.toRadians(15);

  @ParameterizedTest
  @CsvSource({
    // height [m], heading [degrees], distance from the middle of the room to the target [m]
    "0.02, 0, 0",
    "0.8, 90, 0",
    "1.5, 45, -2",
    "1.5, 0, 2.1",
    "1, 90, 2.1",
    "1.5, 180, 2.1",
    "0.5, 270, 2.1",
    "2.5, 270, 0"
  })
  void pictureHasContrastsNearAndFar(double height, double headingDeg, double ahead) {
    SimSnapshot snapshot = new Simulation(TEXTURED, drone -> datagram -> {}, List.of()).snapshot();
    RayTracer eye = new RayTracer(new SceneBuilder().scene(snapshot, 1));
    double heading = Math.toRadians(headingDeg);
    Vec3 place = new Vec3(ahead, 0, height).turned(heading);
    Attitude down = new Attitude(Math.cos(TILT / 2), 0, Math.sin(TILT / 2), 0);

    double[] luma = picture(eye, place, Attitude.ofHeading(heading).after(down));

    assertThat(standardDeviation(luma)).isGreaterThan(25);
  }

  private static double[] picture(RayTracer eye, Vec3 place, Attitude attitude) {
    double[] luma = new double[WIDTH * HEIGHT];
    for (int y = 0; y < RAYS * HEIGHT; y++) {
      for (int x = 0; x < RAYS * WIDTH; x++) {
        double left = 0.5 - (x + 0.5) / (RAYS * WIDTH);
        double up = (0.5 * HEIGHT - (y + 0.5) / RAYS) / WIDTH;
        Vec3 ray = attitude.toRoom(new Vec3(FOCAL_LENGTH, left, up).normalized());
        luma[y / RAYS * WIDTH + x / RAYS] += luma(eye.look(place, ray)) / (RAYS * RAYS);
      }
    }
    return luma;
  }

  /** Returns the luma (ITU-R BT.601), 16 to 235. */
  private static double luma(Rgb color) {
    return 16 + 219 * (0.299 * color.red() + 0.587 * color.green() + 0.114 * color.blue()) / 255;
  }

  private static double standardDeviation(double[] values) {
    double sum = 0;
    double squares = 0;
    for (double value : values) {
      sum += value;
      squares += value * value;
    }
    double mean = sum / values.length;
    return Math.sqrt(squares / values.length - mean * mean);
  }
}
