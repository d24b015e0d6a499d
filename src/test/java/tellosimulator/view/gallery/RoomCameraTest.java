package tellosimulator.view.gallery;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.Scenario;
import tellosimulator.video.camera.PinholeCamera;
import tellosimulator.world.Room;

class RoomCameraTest {

  @ParameterizedTest
  @CsvSource({"5,5,3", "4,6,3", "1,1,1", "200,2,3", "2,200,1", "3,3,100"})
  void allOfARoomIsInThePictureAndFillsIt(double width, double depth, double height) {
    Room room = new Room(width, depth, height);
    PinholeCamera camera = RoomCamera.overview(room);

    double widest = 0;
    for (int corner = 0; corner < 8; corner++) {
      Vec3 place = RoomCamera.corner(room, corner).minus(camera.pose().position());
      Vec3 seen = camera.pose().attitude().toBody(place);
      double focal = camera.intrinsics().focalLength();
      double across = Math.abs(focal * seen.y() / seen.x()) / (RoomCamera.WIDTH / 2.0);
      double down = Math.abs(focal * seen.z() / seen.x()) / (RoomCamera.HEIGHT / 2.0);
      assertThat(seen.x()).isGreaterThan(camera.near());
      widest = Math.max(widest, Math.max(across, down));
    }

    assertThat(widest).isBetween(0.8, 1.0);
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
      assertThat(opaque).as(name).isBetween(argb.length / 4L, argb.length * 9L / 10);
      pictures.add(Arrays.stream(argb).boxed().toList());
    }
    assertThat(pictures).hasSameSizeAs(Gallery.NAMES);
  }
}
