package tellosimulator.video.codec;

import java.util.Arrays;
import tellosimulator.video.picture.Picture;

/** Sequences of frames for encoder tests, named after their content. */
enum TestSequence {
  STILL {
    @Override
    void fill(TestPattern pattern, Picture picture, int number) {
      pattern.textured(picture, 0, 0);
    }
  },
  SLOW {
    @Override
    void fill(TestPattern pattern, Picture picture, int number) {
      pattern.textured(picture, 3 * number, -number);
    }
  },
  FAST {
    @Override
    void fill(TestPattern pattern, Picture picture, int number) {
      pattern.textured(picture, -70 * number, 37 * number);
    }
  },
  /** Motion so large that consecutive frames have hardly anything in common. */
  EXTREME {
    @Override
    void fill(TestPattern pattern, Picture picture, int number) {
      pattern.textured(picture, 1500 * number, -900 * number);
    }
  },
  NOISE {
    @Override
    void fill(TestPattern pattern, Picture picture, int number) {
      pattern.noise(picture);
    }
  },
  FADE {
    @Override
    void fill(TestPattern pattern, Picture picture, int number) {
      TestPattern.flat(picture, 30 + 7 * number);
    }
  },
  /** All samples at their limits, far beyond those of cameras. */
  BLACK_AND_WHITE {
    @Override
    void fill(TestPattern pattern, Picture picture, int number) {
      TestPattern.flat(picture, number % 2 * 255);
      Arrays.fill(picture.u(), (byte) (number % 3 == 0 ? 255 : 0));
    }
  },
  CUT {
    @Override
    void fill(TestPattern pattern, Picture picture, int number) {
      pattern.textured(picture, number < 4 ? number : 2000, 0);
    }
  };

  abstract void fill(TestPattern pattern, Picture picture, int number);
}
