package tellosimulator.scenery.drone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;

class BodyMeshTest {

  /** Limit for fast drawing on a computer without a graphics card. */
  private static final int MOST_TRIANGLES = 6000;

  private final SmoothMeshBuilder mesh = BodyMesh.shape();
  private final MeshProbe shape = new MeshProbe(mesh);

  @Test
  void motorsAreAsFarApartAsOnTheRealDrone() {
    List<Vec3> propellers = BodyMesh.propellers();

    assertThat(propellers.get(0).x() - propellers.get(2).x()).isCloseTo(0.098, within(1e-9));
    assertThat(propellers.get(0).y() - propellers.get(1).y()).isCloseTo(0.0925, within(1e-9));
  }

  @Test
  void itStandsOnTheFloorAndIsAsHighAsTheRealDrone() {
    assertThat(shape.least(Vec3::z)).isCloseTo(0, within(1e-9));
    assertThat(shape.most(Vec3::z)).isCloseTo(0.041, within(5e-4));
  }

  @Test
  void guardsReachAroundThePropellersButHardlyFurther() {
    double tip = 0.098 / 2 + PropellerMesh.RADIUS;

    assertThat(shape.most(Vec3::x)).isBetween(tip, tip + 0.006);
    assertThat(shape.least(Vec3::x)).isBetween(-tip - 0.006, -tip);
  }

  @Test
  void leftAndRightAreAlikeButForTheLens() {
    assertThat(shape.most(Vec3::y)).isCloseTo(-shape.least(Vec3::y), within(1e-4));
  }

  @Test
  void theNoseIsDarkAndInFrontAndHoldsTheLens() {
    assertThat(shape.painted(Palette.NOSE)).isNotEmpty().allMatch(vertex -> vertex.x() > 0.035);
    assertThat(shape.painted(Palette.LENS_RING)).isNotEmpty().allMatch(vertex -> vertex.x() > 0.04);
    assertThat(shape.painted(Palette.COVER)).noneMatch(vertex -> vertex.x() > 0.04);
  }

  @Test
  void allSolidsAreClosed() {
    assertThat(shape.openEdges()).isZero();
  }

  @Test
  void allNormalsLeadOutwards() {
    assertThat(shape.volumes()).hasSizeGreaterThan(30).allMatch(volume -> volume > 0);
  }

  @Test
  void itIsCheapToDraw() {
    assertThat(mesh.triangles()).hasSizeLessThan(MOST_TRIANGLES);
  }
}
