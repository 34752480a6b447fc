#ifndef WF_BASE_QUIET_H
#define WF_BASE_QUIET_H
/* GSL without its error handler, which ends the program: inside such a stretch its functions return their
 * codes. The handler is one for the whole process, so stretches of several threads are counted: the first
 * puts it away, the last puts it back. Every begin needs its end. */
void wf_quiet_begin(void);
void wf_quiet_end(void);
#endif
