package tellosimulator.view.video;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import tellosimulator.video.FilmedPicture;
import tellosimulator.video.VideoFigures;
import tellosimulator.video.picture.Picture;

class TripleBufferTest {

  private final TripleBuffer newest = new TripleBuffer();

  @Test
  void aPictureIsTakenOnceAndTheNewestWins() {
    assertThat(newest.take()).isEmpty();
    newest.filmed(filmed(4, 10));
    newest.filmed(filmed(4, 20));

    assertThat(newest.take().orElseThrow().picture().y()).containsOnly(20);
    assertThat(newest.take()).isEmpty();
  }

  @Test
  void whatWasTakenStaysWhileOthersCome() {
    newest.filmed(filmed(4, 10));
    Picture taken = newest.take().orElseThrow().picture();
    for (int i = 20; i < 25; i++) {
      newest.filmed(filmed(4, i));
    }

    assertThat(taken.y()).containsOnly(10);
    assertThat(newest.take().orElseThrow().picture().y()).containsOnly(24);
  }

  @Test
  void theSizeMayChange() {
    newest.filmed(filmed(4, 10));
    newest.take();
    newest.filmed(filmed(8, 11));

    Picture taken = newest.take().orElseThrow().picture();
    assertThat(taken.width()).isEqualTo(8);
    assertThat(taken.y()).hasSize(32).containsOnly(11);
  }

  @Test
  void noPictureIsEverHalfOfOneAndHalfOfAnother() {
    Thread writer =
        new Thread(
            () -> {
              for (int i = 0; i < 20_000; i++) {
                newest.filmed(filmed(64, i));
              }
            },
            "writer");
    writer.start();
    int taken = 0;
    while (writer.isAlive() || taken == 0) {
      Optional<TripleBuffer.BufferedPicture> now = newest.take();
      if (now.isPresent()) {
        byte[] luma = now.get().picture().y();
        assertThat(luma).containsOnly(luma[0]);
        taken++;
      }
    }
    assertThat(taken).isPositive();
  }

  private static FilmedPicture filmed(int width, int brightness) {
    Picture picture = new Picture(width, 4);
    Arrays.fill(picture.y(), (byte) brightness);
    return new FilmedPicture(picture, Optional.empty(), VideoFigures.NONE, brightness);
  }
}
