package tellosimulator.video.camera;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.ref.ReferenceQueue;
import java.lang.ref.WeakReference;
import org.junit.jupiter.api.Test;
import tellosimulator.math.Vec3;
import tellosimulator.scenery.mesh.Part;
import tellosimulator.video.camera.TestScenes.Quad;

class RenderCacheTest {

  /** On a busy machine the JVM takes some time to clear weak references. */
  private static final int GARBAGE_COLLECTIONS = 60;

  private static final int PATIENCE_MS = 1000;

  private final RenderCache cache = new RenderCache(ColorSpace.YUV);

  @Test
  void entriesAreReused() {
    Part part = part();

    assertThat(cache.texture(part)).isSameAs(cache.texture(part));
    assertThat(cache.mesh(part)).isSameAs(cache.mesh(part));
    assertThat(cache.textures()).isEqualTo(1);
  }

  @Test
  void entriesOfUnreachableTexturesAreDropped() throws InterruptedException {
    for (int i = 0; i < 50; i++) {
      cache.texture(part());
    }

    ReferenceQueue<Object> told = new ReferenceQueue<>();
    for (int i = 0; i < GARBAGE_COLLECTIONS && cache.textures() > 0; i++) {
      WeakReference<Object> collected = new WeakReference<>(new Object(), told);
      System.gc();
      told.remove(PATIENCE_MS);
      assertThat(collected.get()).isNull();
    }

    assertThat(cache.textures()).isZero();
  }

  private static Part part() {
    return TestScenes.painted(TestScenes.noise(16, 1), Quad.ahead(1, Vec3.ZERO, 1)).part();
  }
}
