package tellosimulator.video.codec;

import java.util.Arrays;
import tellosimulator.video.picture.Picture;

/** What happens in a sequence of pictures. */
enum Act {
  STILL {
    @Override
    void play(Motif motif, Picture picture, int number) {
      motif.textured(picture, 0, 0);
    }
  },
  SLOW {
    @Override
    void play(Motif motif, Picture picture, int number) {
      motif.textured(picture, 3 * number, -number);
    }
  },
  FAST {
    @Override
    void play(Motif motif, Picture picture, int number) {
      motif.textured(picture, -70 * number, 37 * number);
    }
  },
  /** So far that hardly anything of one picture is in the next. */
  EXTREME {
    @Override
    void play(Motif motif, Picture picture, int number) {
      motif.textured(picture, 1500 * number, -900 * number);
    }
  },
  NOISE {
    @Override
    void play(Motif motif, Picture picture, int number) {
      motif.noise(picture);
    }
  },
  FADE {
    @Override
    void play(Motif motif, Picture picture, int number) {
      Motif.flat(picture, 30 + 7 * number);
    }
  },
  /** All samples at their limits, far beyond what cameras give. */
  BLACK_AND_WHITE {
    @Override
    void play(Motif motif, Picture picture, int number) {
      Motif.flat(picture, number % 2 * 255);
      Arrays.fill(picture.u(), (byte) (number % 3 == 0 ? 255 : 0));
    }
  },
  CUT {
    @Override
    void play(Motif motif, Picture picture, int number) {
      motif.textured(picture, number < 4 ? number : 2000, 0);
    }
  };

  abstract void play(Motif motif, Picture picture, int number);
}
