package tellosimulator.view.fx;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiConsumer;
import javafx.scene.transform.Affine;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Attitude;
import tellosimulator.math.Pose;
import tellosimulator.math.Vec3;

class FxFramesTest {

  private static final Pose POSE = new Pose(new Vec3(1, 2, 3), Attitude.ofHeading(0.5));

  @Test
  void whatStaysWhereItIsChangesNoTransform() {
    assertThat(changes(FxFrames::aim, POSE)).as("a camera").isZero();
    assertThat(changes(FxFrames::place, POSE)).as("a body").isZero();
  }

  @Test
  void aMoveChangesATransformOnce() {
    Pose moved = new Pose(POSE.position().plusScaled(Vec3.UP, 1), Attitude.ofHeading(0.6));

    assertThat(changes(FxFrames::aim, moved)).as("a camera").isOne();
    assertThat(changes(FxFrames::place, moved)).as("a body").isOne();
  }

  /** Returns the number of changes that a transform reports when it is set to another pose. */
  private static int changes(BiConsumer<Affine, Pose> put, Pose next) {
    Affine transform = new Affine();
    put.accept(transform, POSE);
    AtomicInteger changes = new AtomicInteger();
    transform.setOnTransformChanged(event -> changes.incrementAndGet());
    put.accept(transform, next);
    return changes.get();
  }
}
