// Flies gobot's driver, which knows only the address of a real drone.
package main

import (
	"fmt"
	"io"
	"os"
	"os/exec"
	"regexp"
	"sync/atomic"
	"time"

	"conformance/steps"

	"gobot.io/x/gobot/v2/platforms/dji/tello"
)

const pictures = 100

// decoder is FFmpeg, as in gobot's own example of video; it ends after some pictures.
func decoder() (*exec.Cmd, io.WriteCloser) {
	command := exec.Command("ffmpeg", "-hide_banner", "-loglevel", "error", "-f", "h264", "-i", "pipe:0",
		"-frames:v", fmt.Sprint(pictures), "-f", "framemd5", "-")
	input, err := command.StdinPipe()
	if err != nil {
		panic(err)
	}
	return command, input
}

func main() {
	drone := tello.NewDriver("8888")
	var flight atomic.Pointer[tello.FlightData]
	var flights, tookOff, landed atomic.Int64
	_ = drone.On(tello.FlightDataEvent, func(data any) {
		flight.Store(data.(*tello.FlightData))
		flights.Add(1)
	})
	_ = drone.On(tello.TakeoffEvent, func(any) { tookOff.Add(1) })
	_ = drone.On(tello.LandingEvent, func(any) { landed.Add(1) })
	ffmpeg, video := decoder()
	_ = drone.On(tello.VideoFrameEvent, func(data any) { _, _ = video.Write(data.([]byte)) })
	decoded := make(chan string, 1)
	go func() {
		output, err := ffmpeg.Output()
		decoded <- fmt.Sprint(len(regexp.MustCompile(`(?m)^0,`).FindAll(output, -1)), " ", err)
	}()
	if err := drone.Start(); err != nil {
		panic(err)
	}
	steps.Holds("connect", steps.Await(func() bool { return flight.Load() != nil }, 5), "true")
	_ = drone.StartVideo()
	go func() {
		for range time.Tick(100 * time.Millisecond) {
			_ = drone.StartVideo() // as gobot's example does
		}
	}()
	select {
	case result := <-decoded:
		steps.Holds("decoded pictures", result, fmt.Sprint(pictures, " <nil>"))
	case <-time.After(20 * time.Second):
		steps.Holds("decoded pictures", "too few", "")
	}
	before := flights.Load()
	time.Sleep(2 * time.Second)
	steps.Near("flight data a second", float64(flights.Load()-before)/2, 10, 0.6)

	_ = drone.TakeOff()
	steps.Await(func() bool { return flight.Load().FlyMode == 6 }, 10)
	time.Sleep(time.Second)
	steps.Moved("takeoff", "up", 25, 100)
	steps.Holds("takeoff event", tookOff.Load(), "1")
	_ = drone.Forward(50)
	time.Sleep(2 * time.Second)
	drone.Hover()
	time.Sleep(2 * time.Second)
	steps.Moved("forward 50", "forward", 20, 300)
	steps.Near("height", float64(flight.Load().Height), 3, 1)
	steps.Holds("flies", flight.Load().Flying, "true")
	_ = drone.FrontFlip()
	time.Sleep(4 * time.Second)
	steps.Moved("flip", "forward", 10, 100)
	_ = drone.Land()
	stands := steps.Await(func() bool { return flight.Load().OnGround }, 15)
	steps.Moved("land", "down", 25, 100)
	steps.Holds("stands", stands, "true")
	steps.Holds("landing event", landed.Load(), "1")
	fmt.Println("done")
	os.Exit(0)
}
