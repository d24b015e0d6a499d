package tellosimulator.view.gallery;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.goal.GoalState;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenery.mesh.Rgb;
import tellosimulator.scenery.overlay.OverlayColors;
import tellosimulator.video.camera.PinholeCamera;

class RoomCameraTest {

  @ParameterizedTest
  @CsvSource({"5,5,3", "4,6,3", "2,3,1", "200,2,3", "2,200,1", "3,3,100"})
  void allPlacesAreInThePictureAndFillIt(double width, double depth, double height) {
    Vec3 size = new Vec3(depth, width, height);

    assertThat(widest(RoomCamera.overview(corners(size)), corners(size))).isBetween(0.8, 0.95);
  }

  @Test
  void fewThingsAreSeenFromSoFarThatOneSeesWhereTheyStand() {
    List<Vec3> corners = corners(new Vec3(0.2, 0.2, 0.1));

    // 0.1 m or slightly more from the middle; at 3 m, half the picture is 3 tan 20° = 1.1 m
    assertThat(widest(RoomCamera.overview(corners), corners)).isBetween(0.05, 0.2);
  }

  @Test
  void theNumberOfAGoalOnATableIsInThePicture() {
    int[] argb = new RoomCamera().picture(Gallery.find("table-landing").orElseThrow());
    Rgb active = OverlayColors.of(GoalState.ACTIVE);

    // its blue square is 19 pixels wide; ring and start mark of the drone have another blue
    long blue = Arrays.stream(argb).filter(pixel -> (pixel & 0xffffff) == hex(active)).count();
    assertThat(blue).isGreaterThan(120);
  }

  private static int hex(Rgb color) {
    return color.argb() & 0xffffff;
  }

  /**
   * Returns the distance of the outermost place from the centre, as a fraction of half the picture.
   */
  private static double widest(PinholeCamera camera, List<Vec3> places) {
    double widest = 0;
    for (Vec3 place : places) {
      Vec3 seen = camera.pose().attitude().toBody(place.minus(camera.pose().position()));
      double focal = camera.intrinsics().focalLength();
      double across = Math.abs(focal * seen.y() / seen.x()) / (RoomCamera.WIDTH / 2.0);
      double down = Math.abs(focal * seen.z() / seen.x()) / (RoomCamera.HEIGHT / 2.0);
      assertThat(seen.x()).isGreaterThan(camera.near());
      widest = Math.max(widest, Math.max(across, down));
    }
    return widest;
  }

  /** Returns the corners of a box on the floor. */
  private static List<Vec3> corners(Vec3 size) {
    List<Vec3> corners = new ArrayList<>();
    for (double x : new double[] {-size.x() / 2, size.x() / 2}) {
      for (double y : new double[] {-size.y() / 2, size.y() / 2}) {
        corners.add(new Vec3(x, y, 0));
        corners.add(new Vec3(x, y, size.z()));
      }
    }
    return corners;
  }

  @Test
  void goalsAreInThePicture() {
    Scenario square = Gallery.find(Gallery.NAMES.get(1)).orElseThrow();
    RoomCamera camera = new RoomCamera();

    assertThat(camera.picture(square)).isNotEqualTo(camera.picture(Scenario.of(square.config())));
  }

  @Test
  void eachScenarioHasAPictureOfItsOwnWithNothingAroundTheRoom() {
    RoomCamera camera = new RoomCamera();
    Set<List<Integer>> pictures = new HashSet<>();
    for (String name : Gallery.NAMES) {
      int[] argb = camera.picture(Gallery.find(name).orElseThrow());
      long transparent = Arrays.stream(argb).filter(pixel -> pixel == 0).count();
      long opaque = Arrays.stream(argb).filter(pixel -> pixel >>> 24 == 255).count();
      assertThat(opaque + transparent).isEqualTo(RoomCamera.WIDTH * RoomCamera.HEIGHT);
      assertThat(opaque).as(name).isGreaterThan(argb.length * 3L / 4);
      pictures.add(Arrays.stream(argb).boxed().toList());
    }
    assertThat(pictures).hasSameSizeAs(Gallery.NAMES);
  }
}
