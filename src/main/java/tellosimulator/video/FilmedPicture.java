package tellosimulator.video;

import java.util.Optional;
import tellosimulator.video.codec.AccessUnit;
import tellosimulator.video.picture.Picture;

/**
 * A new picture of a drone's video. The image and the encoded bytes are reused for the next
 * picture, so receivers that keep them must copy them.
 *
 * @param picture the camera's image; blank if the picture was received and not decoded
 * @param encoded the picture as H.264; empty while no encoded picture is needed
 * @param figures the figures of the stream
 * @param nanos time of the picture [ns]; only differences between times matter
 */
public record FilmedPicture(
    Picture picture, Optional<AccessUnit> encoded, VideoFigures figures, long nanos) {}
