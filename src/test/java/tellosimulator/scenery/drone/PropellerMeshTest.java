package tellosimulator.scenery.drone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.math.Vec3;

class PropellerMeshTest {

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void itMeasuresThreeInchesAndIsClosed(boolean clockwise) {
    SmoothMeshBuilder mesh = PropellerMesh.shape(clockwise);
    MeshProbe shape = new MeshProbe(mesh);

    assertThat(shape.most(Vec3::x) - shape.least(Vec3::x)).isCloseTo(3 * 0.0254, within(1e-6));
    assertThat(shape.openEdges()).isZero();
    assertThat(shape.volumes()).hasSize(2).allMatch(volume -> volume > 0);
    assertThat(mesh.triangles()).hasSizeLessThan(200);
  }

  @Test
  void theLeadingEdgeIsTheHigherOne() {
    assertThat(heightInFrontOfTheBladeAtPlusX(false)).isPositive();
    assertThat(heightInFrontOfTheBladeAtPlusX(true)).isNegative();
  }

  /** Turning counter-clockwise, the blade at +x moves towards +y. */
  private static double heightInFrontOfTheBladeAtPlusX(boolean clockwise) {
    return PropellerMesh.shape(clockwise).vertices().stream()
        .filter(vertex -> vertex.x() > 0.01 && vertex.y() > 0.002)
        .mapToDouble(Vec3::z)
        .average()
        .orElseThrow();
  }
}
