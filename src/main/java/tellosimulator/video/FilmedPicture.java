package tellosimulator.video;

import java.util.Optional;
import tellosimulator.video.codec.AccessUnit;
import tellosimulator.video.picture.Picture;

/**
 * A picture that was just made. Picture and bytes are used again for the next one: whoever keeps
 * them copies them.
 *
 * @param picture what the camera saw
 * @param encoded the same as H.264; empty while nobody needs that
 * @param figures how the stream goes
 * @param nanos when it was taken, on any clock [ns]
 */
public record FilmedPicture(
    Picture picture, Optional<AccessUnit> encoded, VideoFigures figures, long nanos) {}
