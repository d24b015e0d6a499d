package tellosimulator.video;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import tellosimulator.model.VideoSettings;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.video.camera.CameraId;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.codec.H264Encoder;
import tellosimulator.video.picture.Picture;

class FilmsTest {

  private final SimSnapshot snapshot =
      new Simulation(SimConfig.DEFAULT, drone -> (peer, text) -> {}, report -> {}, List.of())
          .snapshot();
  private final List<Camera> cameras = new ArrayList<>();
  private Optional<RuntimeException> fault = Optional.empty();
  private Object seen = "a room";
  private final Films films = new Films(this::camera, H264Encoder::new);

  /** One that sees what a test says. */
  private final class Camera implements FrameSource {
    private int pictures;

    @Override
    public void film(SimSnapshot moment, CameraId shot, Picture picture) {
      fault.ifPresent(
          exception -> {
            throw exception;
          });
      pictures++;
    }

    @Override
    public Object sight(SimSnapshot moment, CameraId shot) {
      return seen;
    }
  }

  private FrameSource camera() {
    cameras.add(new Camera());
    return cameras.get(cameras.size() - 1);
  }

  @Test
  void theFirstDroneBeginsWithThePreparedPicture() {
    films.prepare(snapshot);
    shoot(films.film(1));

    assertThat(cameras).hasSize(1);
    assertThat(cameras.get(0).pictures).isEqualTo(1);
  }

  @Test
  void preparingTwiceTakesOnePictureWhereNothingHasChanged() {
    films.prepare(snapshot);
    films.prepare(snapshot);

    assertThat(cameras).hasSize(1);
    assertThat(cameras.get(0).pictures).isEqualTo(1);
  }

  @Test
  void anEarlyPictureComesTooLateWhereThereIsOne() {
    films.prepare(snapshot);
    seen = "an empty room";
    films.prepareEarly(snapshot);

    assertThat(cameras).hasSize(1);
    assertThat(cameras.get(0).pictures).isEqualTo(1);
  }

  @Test
  void otherDronesHaveFilmsOfTheirOwn() {
    films.prepare(snapshot);
    films.film(2);

    assertThat(cameras).hasSize(2);
  }

  @Test
  void aPreparedFilmIsGivenAwayOnce() {
    films.prepare(snapshot);
    Film first = films.film(1);

    assertThat(films.film(1)).isNotSameAs(first);
  }

  @Test
  void nothingIsPreparedForADroneThatFilms() {
    films.film(1);
    films.prepare(snapshot);

    assertThat(cameras).hasSize(1);
    assertThat(cameras.get(0).pictures).isZero();
  }

  @Test
  void afterAFailureTheFirstDroneHasAFilmOfItsOwn() {
    fault = Optional.of(new IllegalStateException("no paint"));
    assertThatThrownBy(() -> films.prepare(snapshot)).hasMessage("no paint");
    fault = Optional.empty();
    shoot(films.film(1));

    assertThat(cameras).hasSize(2);
    assertThat(cameras.get(1).pictures).isEqualTo(1);
  }

  private void shoot(Film film) {
    film.shoot(snapshot, VideoFormat.of(VideoSettings.DEFAULT));
  }
}
